#lang racket/base
;; What the tests of picture files share: scratch folders, one-line errors, mutated files, and a
;; small picture.
(provide call-with-folder write-file one-line-error check-one-line check-mutations
         small-image random-image repaired)
(require racket/file racket/flonum rackunit "../../private/image/image.rkt")

;; Calls use with a fresh folder that is deleted afterwards.
(define (call-with-folder use)
  (define folder (make-temporary-file "pictures~a" 'directory))
  (dynamic-wind void
                (lambda () (use folder))
                (lambda () (delete-directory/files folder))))

(define (write-file path bytes)
  (call-with-output-file path #:exists 'truncate (lambda (out) (write-bytes bytes out)))
  path)

;; The message of the exn:fail:user that thunk raises; any other outcome is a failed check.
(define (one-line-error thunk)
  (with-handlers ([exn:fail:user? exn-message])
    (define result (thunk))
    (fail (format "expected an error, got ~e" result))
    ""))

;; thunk raises a one-line error whose message contains each of the parts.
(define (check-one-line thunk . parts)
  (define message (one-line-error thunk))
  (check-false (regexp-match? #rx"[\r\n]" message) message)
  (for ([part (in-list parts)])
    (check-true (regexp-match? (regexp-quote part) message)
                (format "~s should contain ~s" message part))))

;; Reads count mutations of a file's bytes, made with a fixed seed: changed, removed, doubled and
;; inserted bytes, and truncations, half of them within the first header-length bytes. Each must
;; load as an Image or raise a one-line exn:fail:user; all together take at most the seconds given
;; and half a gibibyte. Returns how many loaded.
(define (check-mutations original read-image count header-length #:seconds [seconds 60])
  (define generator (make-pseudo-random-generator))
  (parameterize ([current-pseudo-random-generator generator])
    (random-seed 20240229))
  (define (pick n) (if (positive? n) (random n generator) 0))
  (define (mutate b)
    (define size (bytes-length b))
    (define at (pick (if (zero? (pick 2)) (min size header-length) size)))
    (define rest (min size (+ at 1)))
    (case (pick 6)
      [(0 1) (bytes-append (subbytes b 0 at) (bytes (pick 256)) (subbytes b rest))]
      [(2) (bytes-append (subbytes b 0 at) (subbytes b rest))]
      [(3) (bytes-append (subbytes b 0 at) (bytes (+ 48 (pick 10))) (subbytes b at))]
      [(4) (bytes-append (subbytes b 0 rest) (subbytes b at))]
      [else (subbytes b 0 at)]))
  (call-with-folder
   (lambda (folder)
     (define path (build-path folder "mutated"))
     (define loaded #f)
     (define custodian (make-custodian))
     (custodian-limit-memory custodian (+ (current-memory-use) (* 512 1024 1024)) custodian)
     (define reader
       (parameterize ([current-custodian custodian])
         (thread
          (lambda ()
            (set! loaded
                  (for/sum ([_ (in-range count)])
                    (define mutant
                      (for/fold ([b original]) ([_ (in-range (+ 1 (pick 3)))]) (mutate b)))
                    (write-file path mutant)
                    (with-handlers ([exn:fail:user?
                                     (lambda (e)
                                       (check-false (regexp-match? #rx"[\r\n]" (exn-message e)))
                                       (check-true (regexp-match? #rx"mutated: " (exn-message e))
                                                   (exn-message e))
                                       0)]
                                    [exn:fail?
                                     (lambda (e)
                                       (define start (min 60 (bytes-length mutant)))
                                       (fail (format "~a for ~s" (exn-message e)
                                                     (subbytes mutant 0 start)))
                                       0)])
                      (define image (read-image path))
                      (check-equal? (flvector-length (Image-pixels image))
                                    (* 3 (Image-width image) (Image-height image)))
                      1)))))))
     (check-not-false (sync/timeout seconds reader) "the reader hangs")
     (custodian-shutdown-all custodian)
     (check-not-false loaded "the reader died or exceeded its memory")
     loaded)))

;; 2x2: red, green above blue, white; in single precision exactly as here.
(define small-image
  (make-Image 2 2 (flvector 1.0 0.0 0.0  0.0 1.0 0.0
                            0.0 0.0 1.0  1.0 1.0 1.0)))

;; A picture of numbers between low and high from a fixed seed.
(define (random-image width height seed [low 0.0] [high 1.0])
  (define generator (make-pseudo-random-generator))
  (parameterize ([current-pseudo-random-generator generator])
    (random-seed seed))
  (make-Image width height
              (for/flvector #:length (* 3 width height) ([_ (in-range (* 3 width height))])
                (+ low (* (- high low) (random generator))))))

;; repaired : a PNG's bytes with the checksums its chunks should have, as far as it has chunks.
(define (repaired png)
  (define result (bytes-copy png))
  (let loop ([at 8])
    (define data-end
      (and (<= (+ at 12) (bytes-length png))
           (+ at 8 (integer-bytes->integer png #f #t at (+ at 4)))))
    (when (and data-end (<= (+ data-end 4) (bytes-length png)))
      (integer->integer-bytes (checksum png (+ at 4) data-end) 4 #f #t result data-end)
      (loop (+ data-end 4))))
  result)
(define (checksum bytes start end)
  (for/fold ([crc #xFFFFFFFF] #:result (- #xFFFFFFFF crc)) ([byte (in-bytes bytes start end)])
    (for/fold ([crc (bitwise-xor crc byte)]) ([_ (in-range 8)])
      (bitwise-xor (quotient crc 2) (if (odd? crc) #xEDB88320 0)))))
