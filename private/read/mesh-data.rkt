#lang racket/base
;; The plain record every mesh reader returns, and the last step they share: triangles without
;; area are dropped and counted, normals are kept only when every one of them can be used.

(provide (struct-out mesh-data)
         (struct-out mesh-material)
         finish-mesh)

(require racket/fixnum
         racket/flonum
         "orientation.rkt")

;; One mesh, as read.
;;   positions  flvector, 3 per vertex, all finite
;;   normals    flvector, 3 per vertex, or #f: to be computed; not normalized
;;   uvs        flvector, 2 per vertex, or #f
;;   triangles  fxvector, 3 vertex indices per triangle, none of zero area
;;   groups     list of (list name first-triangle count) in file order: the runs of triangles that
;;              use one material; name is a string, or #f for no material
;;   materials  immutable hash from name to mesh-material
;;   dropped    number of triangles dropped: repeated vertices or zero area
;;   warnings   list of strings, one line each
(struct mesh-data (positions normals uvs triangles groups materials dropped warnings))

;; What a material file says: Kd Ks Ke are lists of three flonums, Ns d Ni flonums; #f when absent.
(struct mesh-material (Kd Ks Ns d Ni Ke))

;; Makes a mesh-data. runs is a list of (cons name first-triangle) in rising order, the first at 0;
;; fail-empty is called, and must raise, when no triangle is left; label starts the warnings.
(define (finish-mesh label positions normals uvs triangles runs materials warnings fail-empty)
  (define-values (kept kept-runs dropped) (drop-degenerate positions triangles runs))
  (when (fx= 0 (fxvector-length kept))
    (fail-empty))
  (define bad-normals (if normals (count-unusable-normals normals kept) 0))
  (define more
    (append
     (if (fx= dropped 0)
         '()
         (list (format "~a: ~a degenerate triangle~a dropped (zero area or repeated vertices)"
                       label dropped (if (fx= dropped 1) " was" "s were"))))
     (if (fx= bad-normals 0)
         '()
         (list (format "~a: ~a zero or non-finite normals: the file's normals are ignored"
                       label bad-normals)))))
  (mesh-data positions (and (fx= bad-normals 0) normals) uvs kept
             (runs->groups kept-runs (fxquotient (fxvector-length kept) 3))
             materials dropped (append warnings more)))

;; The triangles that have an area, the runs moved accordingly, and the number dropped.
(define (drop-degenerate positions triangles runs)
  (define end (fxvector-length triangles))
  (define kept (make-fxvector end))
  (let loop ([from 0] [to 0] [runs runs] [moved '()])
    (cond
      [(and (pair? runs) (fx= (fx* 3 (cdar runs)) from))
       (loop from to (cdr runs) (cons (cons (caar runs) (fxquotient to 3)) moved))]
      [(fx= from end)
       (values (if (fx= to end) kept (fxvector-copy kept 0 to))
               (reverse moved)
               (fxquotient (fx- end to) 3))]
      [else
       (define a (fxvector-ref triangles from))
       (define b (fxvector-ref triangles (fx+ from 1)))
       (define c (fxvector-ref triangles (fx+ from 2)))
       (cond
         [(or (fx= a b) (fx= b c) (fx= c a) (zero-area? positions a b c))
          (loop (fx+ from 3) to runs moved)]
         [else
          (fxvector-set! kept to a)
          (fxvector-set! kept (fx+ to 1) b)
          (fxvector-set! kept (fx+ to 2) c)
          (loop (fx+ from 3) (fx+ to 3) runs moved)])])))

;; Empty runs vanish, neighbours of one name join: (list (list name first count) ...).
(define (runs->groups runs triangle-count)
  (define-values (groups end)
    (for/fold ([groups '()] [end triangle-count]) ([run (in-list (reverse runs))])
      (define first (cdr run))
      (define count (fx- end first))
      (values
       (cond
         [(fx= count 0) groups]
         [(and (pair? groups) (equal? (caar groups) (car run)))
          (cons (list (car run) first (fx+ count (caddar groups))) (cdr groups))]
         [else (cons (list (car run) first count) groups)])
       first)))
  groups)

;; How many corners have a normal that gives no direction.
(define (count-unusable-normals normals triangles)
  (for/fold ([bad 0]) ([v (in-fxvector triangles)])
    (define x (flvector-ref normals (fx* 3 v)))
    (define y (flvector-ref normals (fx+ 1 (fx* 3 v))))
    (define z (flvector-ref normals (fx+ 2 (fx* 3 v))))
    (define size (fl+ (flabs x) (fl+ (flabs y) (flabs z))))
    (if (and (fl> size 0.0) (fl< size +inf.0)) bad (fx+ bad 1))))
