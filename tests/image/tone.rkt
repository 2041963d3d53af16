#lang racket/base
;; The sRGB transfer function, luminance, and the table of bytes against its formula.
(module+ test
  (require racket/flonum rackunit "../../private/image/tone.rkt")

  (define (check-relative name actual expected tolerance)
    (check-true (<= (abs (- actual expected)) (* tolerance (abs expected)))
                (format "~a: ~a should be ~a" name actual expected)))

  ;; I01, I03, I05 of the truth table: relative tolerance 1e-12
  (for ([x (in-list '(0.0 0.0031308 0.18 0.2140411404822 0.5 1.0))]
        [expected (in-list '(0.0 0.040449936 0.46135612950044165 0.49999999999996495
                                 0.73535698305244949 1.0))])
    (check-relative 'I01 (sRGB-encode x) expected 1e-12))
  (for ([byte (in-list '(1 128 188))]
        [expected (in-list '(0.00030352698354883749 0.21586050011389916 0.50288645803256839))])
    (check-relative 'I03 (sRGB-decode (/ byte 255)) expected 1e-12)
    (check-equal? (flvector-ref (sRGB-decoding-table 255) byte) (sRGB-decode (/ byte 255.0))))
  (check-relative 'I05 (luminance 0.2 0.4 0.6) 0.37192 1e-12)

  ;; just above the ends of the linear segments, where it and the power law differ by 1e-6 of the
  ;; value (40-digit arithmetic); relative tolerance 1e-12
  (check-relative 'encode (sRGB-encode 0.0031309) 0.04045117777859804 1e-12)
  (check-relative 'decode (sRGB-decode 0.0404501) 0.003130815155192344 1e-12)

  ;; I02: exact
  (check-equal? (map sRGB-byte '(0.18 0.5 0.9)) '(118 188 243))
  (check-equal? (linear->sRGB-bytes (flvector 0.18 0.5 0.9)) (bytes 118 188 243))

  ;; encode and decode undo each other to 1e-12, on both segments and beyond
  (for ([i (in-range 1 3001)])
    (define x (/ i 2000.0))
    (check-relative 'inverse (sRGB-decode (sRGB-encode x)) x 1e-12))
  (check-relative 'negative (sRGB-encode -0.5) -6.46 1e-12)

  ;; every byte survives decoding and encoding
  (check-equal? (linear->sRGB-bytes (sRGB-decoding-table 255)) (apply bytes (for/list ([i 256]) i)))

  ;; the formula, written out here once more
  (define (formula-byte x)
    (define clamped (cond [(not (= x x)) 0.0] [(< x 0.0) 0.0] [(> x 1.0) 1.0] [else x]))
    (define encoded
      (if (<= clamped 0.0031308)
          (* 12.92 clamped)
          (- (* 1.055 (flexpt clamped (/ 1.0 2.4))) 0.055)))
    (inexact->exact (round (* 255.0 encoded))))
  (define (neighbour x steps)
    (floating-point-bytes->real
     (integer->integer-bytes (+ steps (integer-bytes->integer (real->floating-point-bytes x 8) #t))
                             8 #t)))
  (define (check-bytes values)
    (define table (linear->sRGB-bytes (apply flvector values)))
    (for ([x (in-list values)] [byte (in-bytes table)])
      (unless (and (= byte (formula-byte x)) (= byte (sRGB-byte x)))
        (fail (format "~a: table ~a, sRGB-byte ~a, formula ~a"
                      x byte (sRGB-byte x) (formula-byte x))))))

  ;; exact: 64 flonums on either side of the edge between two bytes, and its wider surroundings
  (define edge-bytes
    (for/list ([byte (in-range 1 256)])
      (define edge (sRGB-decode (/ (- byte 0.5) 255.0)))
      (check-bytes (for/list ([step (in-range -64 65)]) (neighbour edge step)))
      (check-bytes (for/list ([step (in-range -40 41)]) (* edge (+ 1.0 (* step 1e-12)))))
      (list (sRGB-byte (* edge (- 1.0 1e-10))) (sRGB-byte (* edge (+ 1.0 1e-10))))))
  ;; so the edges above are the real ones
  (check-equal? edge-bytes (for/list ([byte (in-range 1 256)]) (list (- byte 1) byte)))
  ;; exact: around the edges of the table's bins, on a fine grid, and the odd values
  (for ([bin (in-range 1 4097)])
    (check-bytes (for/list ([step (in-range -2 3)]) (neighbour (/ bin 4096.0) step))))
  (check-bytes (for/list ([i (in-range 60000)]) (/ (exact->inexact i) 59999.0)))
  (check-bytes (list +nan.0 +inf.0 -inf.0 0.0 -0.0 -1.0 1.0 2.0 1e300 -1e300 4.9e-324
                     (neighbour 1.0 -1) (neighbour 1.0 1)))
  (check-equal? (linear->sRGB-bytes (flvector +nan.0 +inf.0 -inf.0 -0.0)) (bytes 0 255 0 0))

  ;; a part of a flvector into a part of a byte string
  (define target (make-bytes 5 9))
  (linear->sRGB-bytes! target 1 (flvector 0.0 1.0 0.5 0.18 0.9) 2 3)
  (check-equal? target (bytes 9 188 118 243 9))
  (check-exn exn:fail? (lambda () (linear->sRGB-bytes! (make-bytes 2) 0 (flvector 0.0 0.0 0.0) 0 3))))
