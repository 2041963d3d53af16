#lang racket/base
;; raco raytrace compare: the table of a pair with known differences, the difference picture, and
;; what is refused.
(module+ test
  (require racket/flonum racket/port rackunit "support.rkt"
           "../../private/command/compare.rkt" "../../private/image/image.rkt"
           "../../private/image/write.rkt")

  (define (compared . words)
    (with-output-to-string (lambda () (compare-pictures "raco raytrace compare" words))))

  (call-with-folder
   (lambda (folder)
     (parameterize ([current-directory folder])
       (Image-write (make-Image 2 1 (flvector 0.5 0.5 0.5 0.5 0.5 0.5)) "a.pfm")
       (Image-write (make-Image 2 1 (flvector 0.5 0.5 0.5 0.5 0.5 0.25)) "b.pfm")
       (Image-write (make-Image 1 1 (flvector 0.5 0.5 0.5)) "c.pfm")
       (check-equal? (compared "a.pfm" "a.pfm")
                     (string-append "RMSE    0\nRMSE1   0\nrelMSE  0\nbias    0 %\n"
                                    "PSNR    infinite dB\nworst   0 at x 0, y 0\n"))
       ;; one channel of six differs by 1/4: RMSE 1/4/sqrt 6, relMSE 1/16/0.0725/6,
       ;; bias 3/2.75 - 1, PSNR -20 log10 RMSE; to six digits
       (check-equal? (compared "-o" "d.png" "a.pfm" "b.pfm")
                     (string-append "RMSE    0.102062\nRMSE1   0.102062\nrelMSE  0.143678\n"
                                    "bias    9.09091 %\nPSNR    19.8227 dB\n"
                                    "worst   0.25 at x 1, y 0\n"))
       (check-equal? (Image-width (Image-read "d.png")) 2)
       (define (refused pattern . words) (check-exn pattern (lambda () (apply compared words))))
       (refused #rx"expected pictures of the same size, found 2x1 and 1x1" "a.pfm" "c.pfm")
       (refused #rx"^none.pfm: expected a picture file" "a.pfm" "none.pfm")
       (refused #rx"^e.gif: expected a file name" "a.pfm" "b.pfm" "-o" "e.gif")
       (refused #rx"^expects 2 <A> <B>|^expects <A> <B>" "a.pfm")
       (check-equal? (files folder) '("a.pfm" "b.pfm" "c.pfm" "d.png")))
     ;; the real command
     (define result (run-command folder "compare" "a.pfm" "a.pfm"))
     (check-equal? (outcome-code result) 0)
     (check-equal? (outcome-errors result) "")
     (check-equal? (subbytes (outcome-output result) 0 10) #"RMSE    0\n")
     (check-one-line-error (run-command folder "compare" "a.pfm" "c.pfm") "same size"))))
