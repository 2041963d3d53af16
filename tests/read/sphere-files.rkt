#lang racket/base
;; Writes spheres of any number of triangles in every mesh format, for the readers' tests.

(provide sphere-kinds
         write-sphere
         sphere-triangle-count
         sphere-vertex-count)

(require racket/math)

;; The formats: each is a symbol whose file extension is the part before the dash.
(define sphere-kinds
  '(obj-normals obj-plain ply-ascii ply-little ply-big stl-ascii stl-binary))

;; A sphere of 2 * rings * (rings - 1) triangles in rings bands of rings columns, without a seam.
(define (sphere-triangle-count rings) (* 2 rings (- rings 1)))
(define (sphere-vertex-count rings) (+ 2 (* rings (- rings 1))))

;; Vertex i as three flonums: the poles first, then the circles from north to south.
(define (sphere-vertex rings i)
  (define-values (circle column) (quotient/remainder (- i 2) rings))
  (cond
    [(= i 0) (values 0.0 1.0 0.0)]
    [(= i 1) (values 0.0 -1.0 0.0)]
    [else
     (define theta (/ (* pi (+ circle 1)) rings))
     (define phi (/ (* 2 pi column) rings))
     (values (* (sin theta) (cos phi)) (cos theta) (* (sin theta) (sin phi)))]))

;; Calls (proc a b c) for each triangle, counterclockwise seen from outside.
(define (for-each-triangle rings proc)
  (define (vertex circle column) (+ 2 (* circle rings) (modulo column rings)))
  (for ([column (in-range rings)])
    (proc 0 (vertex 0 (+ column 1)) (vertex 0 column))
    (proc 1 (vertex (- rings 2) column) (vertex (- rings 2) (+ column 1))))
  (for* ([circle (in-range (- rings 2))] [column (in-range rings)])
    (define-values (a b) (values (vertex circle column) (vertex circle (+ column 1))))
    (define-values (c d) (values (vertex (+ circle 1) (+ column 1)) (vertex (+ circle 1) column)))
    (proc a b c)
    (proc a c d)))

;; Writes the sphere to path.
(define (write-sphere kind rings path)
  (define write-body
    (case kind
      [(obj-normals) (λ (out) (write-obj rings out #t))]
      [(obj-plain) (λ (out) (write-obj rings out #f))]
      [(ply-ascii) (λ (out) (write-ply rings out 'ascii))]
      [(ply-little) (λ (out) (write-ply rings out 'little))]
      [(ply-big) (λ (out) (write-ply rings out 'big))]
      [(stl-ascii) (λ (out) (write-stl-ascii rings out))]
      [(stl-binary) (λ (out) (write-stl-binary rings out))]))
  (call-with-output-file path write-body #:exists 'truncate))

(define (write-numbers out . numbers)
  (for ([n (in-list numbers)] [i (in-naturals)])
    (unless (= i 0) (write-char #\space out))
    (write n out)))

(define (write-obj rings out normals?)
  (for ([i (in-range (sphere-vertex-count rings))])
    (define-values (x y z) (sphere-vertex rings i))
    (write-string "v " out)
    (write-numbers out x y z)
    (when normals?
      (write-string "\nvn " out)
      (write-numbers out x y z))
    (newline out))
  (for-each-triangle
   rings
   (λ corners
     (write-string "f" out)
     (for ([v (in-list corners)])
       (write-char #\space out)
       (write (+ v 1) out)
       (when normals?
         (write-string "//" out)
         (write (+ v 1) out)))
     (newline out))))

(define (write-ply rings out format)
  (fprintf out "ply\nformat ~a 1.0\ncomment a sphere\n"
           (case format
             [(ascii) "ascii"]
             [(little) "binary_little_endian"]
             [else "binary_big_endian"]))
  (fprintf out "element vertex ~a\nproperty float x\nproperty float y\nproperty float z\n"
           (sphere-vertex-count rings))
  (fprintf out "element face ~a\nproperty list uchar int vertex_indices\nend_header\n"
           (sphere-triangle-count rings))
  (define big? (eq? format 'big))
  (for ([i (in-range (sphere-vertex-count rings))])
    (define-values (x y z) (sphere-vertex rings i))
    (cond
      [(eq? format 'ascii)
       (write-numbers out x y z)
       (newline out)]
      [else
       (for ([n (in-list (list x y z))])
         (write-bytes (real->floating-point-bytes n 4 big?) out))]))
  (for-each-triangle
   rings
   (λ corners
     (cond
       [(eq? format 'ascii)
        (apply write-numbers out 3 corners)
        (newline out)]
       [else
        (write-byte 3 out)
        (for ([v (in-list corners)])
          (write-bytes (integer->integer-bytes v 4 #t big?) out))]))))

(define (write-stl-ascii rings out)
  (write-string "solid sphere\n" out)
  (for-each-triangle
   rings
   (λ corners
     (write-string "facet normal 0 0 0\nouter loop\n" out)
     (for ([v (in-list corners)])
       (define-values (x y z) (sphere-vertex rings v))
       (write-string "vertex " out)
       (write-numbers out x y z)
       (newline out))
     (write-string "endloop\nendfacet\n" out)))
  (write-string "endsolid sphere\n" out))

;; The header starts with solid on purpose: readers must not take it for text.
(define (write-stl-binary rings out)
  (write-bytes #"solid but binary" out)
  (write-bytes (make-bytes 64 32) out)
  (write-bytes (integer->integer-bytes (sphere-triangle-count rings) 4 #f #f) out)
  (for-each-triangle
   rings
   (λ corners
     (write-bytes (make-bytes 12 0) out)
     (for ([v (in-list corners)])
       (define-values (x y z) (sphere-vertex rings v))
       (for ([n (in-list (list x y z))])
         (write-bytes (real->floating-point-bytes n 4 #f) out)))
     (write-bytes #"\0\0" out))))
