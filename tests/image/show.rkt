#lang racket/base
;; A picture shown: itself to ports that take pictures, half blocks to others.
(module+ test
  (require racket/flonum racket/string rackunit raytrace
           (only-in "../../private/image/image.rkt" make-Image))

  (define image (make-Image 4 2 (make-flvector 24 0.5)))
  (define (shown image . columns)
    (define out (open-output-string))
    (if (null? columns) (show image out) (show image out #:columns (car columns)))
    (get-output-string out))

  (test-case "half blocks, two rows a line, at most so many a line"
    (check-equal? (length (regexp-match* #rx"▀" (shown image))) 4)
    (check-equal? (length (regexp-match* #rx"\n" (shown image))) 1)
    (check-equal? (length (regexp-match* #rx"▀" (shown image 2))) 2))

  (test-case "as wide as the terminal says"
    (define wide (make-Image 200 1 (make-flvector 600 0.5)))
    (define (blocks columns)
      (parameterize ([current-environment-variables
                      (make-environment-variables #"COLUMNS" columns)])
        (length (regexp-match* #rx"▀" (shown wide)))))
    (check-equal? (map blocks '(#"50" #"no" #"-3")) '(50 80 80)))

  (test-case "the picture itself where it can be seen"
    (define got '())
    (define out
      (make-output-port 'pictures always-evt
                        (lambda (bytes start end block? break?) (- end start))
                        void
                        (lambda (value block? break?) (set! got (cons value got)) #t)))
    (show image out)
    (check-equal? got (list image)))

  (test-case "no Image, no picture"
    (check-exn #rx"an Image" (lambda () (show 'no)))))
