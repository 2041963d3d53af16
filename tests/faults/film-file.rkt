#lang racket/base
;; Films on disk: what was written is what is read; of a thousand damaged files each is refused with a
;; line that names it.
(module+ test
  (require racket/file racket/flonum rackunit "../command/support.rkt"
           "../../private/render/film-file.rkt" "../../private/render/film.rkt"
           "../../private/render/pixel.rkt")

  (define tiling (Tiling 30 20 8 '(2 3 21 13)))
  (define count (tile-count tiling))
  (check-equal? count 6)
  (define generator (make-pseudo-random-generator))
  (parameterize ([current-pseudo-random-generator generator]) (random-seed 5))
  (define (numbers length)
    (for/flvector #:length length ([k (in-range length)]) (random generator)))
  ;; all tiles but number 2 are done
  (define tallies (make-flvector (* tally-places count) 0.0))
  (for ([tile (in-list '(0 1 3 4 5))]) (flvector-set! tallies (* tile tally-places) 2.0))
  (define (empty-target kind)
    (define pixels (* 21 13))
    (Target (make-flvector (* pixels (if (eq? kind 'passes) pixel-places 3)) +nan.0)
            (case kind
              [(passes) #f]
              [(single) (flvector)]
              [else (make-flvector (* pixels 3) +nan.0)])
            (make-flvector (* tally-places count) 0.0)))
  (define (full-target kind)
    (define empty (empty-target kind))
    (Target (numbers (flvector-length (Target-film empty)))
            (and (Target-errors empty) (numbers (flvector-length (Target-errors empty))))
            tallies))
  (define settings '(("seed" . 1)))
  (define state '(1 2.0 0.0 1.0 1.0))
  (define (write-file path target)
    (call-with-output-file path #:exists 'truncate
      (lambda (out) (film-file-write out 'checkpoint settings #f state tiling target))))

  (call-with-folder
   (lambda (folder)
     (define path (build-path folder "a.checkpoint"))
     (for ([kind (in-list '(passes single finished))])
       (define target (full-target kind))
       (check-true (write-file path target))
       (define head (film-file-header path "a checkpoint"))
       (check-equal? (list (header-kind head) (header-settings head) (header-state head))
                     (list 'checkpoint settings state))
       (define read (empty-target kind))
       (check-equal? (film-file-load! path "a checkpoint" tiling read)
                     (if (eq? kind 'passes) '(0 1 2 3 4 5) '(0 1 3 4 5)))
       ;; written again it is the same file
       (define bytes (file->bytes path))
       (write-file path read)
       (check-true (equal? bytes (file->bytes path))))

     ;; a tile that is being written for ever cannot be kept
     (define torn (full-target 'passes))
     (flvector-set! (Target-tallies torn) (* 2 tally-places) 1.0)
     (check-false (write-file path torn))
     (flvector-set! (Target-tallies torn) (* 2 tally-places) 0.0)

     (write-file path (full-target 'finished))
     (define whole (file->bytes path))
     (define (mutated)
       (define at (random (bytes-length whole) generator))
       (define copy (bytes-copy whole))
       (case (random 4 generator)
         [(0) (bytes-set! copy at (bitwise-xor (bytes-ref copy at) (+ 1 (random 255 generator)))) copy]
         [(1) (subbytes copy 0 at)]
         [(2) (bytes-append (subbytes copy 0 at) (bytes (random 256 generator)) (subbytes copy at))]
         [else (bytes-append copy (subbytes copy 0 (+ 1 at)))]))
     (define refused
       (for/sum ([k (in-range 1000)])
         (call-with-output-file path #:exists 'truncate (lambda (out) (write-bytes (mutated) out)))
         (with-handlers ([exn:fail:user?
                          (lambda (e) (if (regexp-match? #rx"a.checkpoint: [^\n]*$" (exn-message e)) 1 0))])
           (film-file-load! path "a checkpoint" tiling (empty-target 'finished))
           0)))
     (check-equal? refused 1000))))
