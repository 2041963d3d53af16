#lang racket/base
;; What may be asked of a render: limits are within, what lies beyond is refused by name.
(module+ test
  (require rackunit "../../private/command/values.rkt")

  (define (refusal check . arguments)
    (with-handlers ([exn:fail:user? exn-message])
      (apply check arguments)
      "taken"))

  (check-equal? (map text->natural '("0" "007" "1e9" "-1" "+1" "1.0" "" "NaN" "1 " "#x10"))
                '(0 7 #f #f #f #f #f #f #f #f))
  (check-equal? (text->natural (make-string 18 #\9)) 999999999999999999)
  (check-equal? (text->natural (make-string 19 #\9)) #f)
  (check-equal? (text->naturals "1,2,,x" #rx",") '(1 2 #f #f))

  (for ([row (in-list (list (list check-samples 1 1000000000) (list check-seed 0 4294967295)
                            (list check-workers 1 1024) (list check-tile 1 100000)
                            (list check-max-depth 0 1000000000)))])
    (define-values (check low high) (apply values row))
    (define expected (format "expected a whole number from ~a to ~a" low high))
    (check-equal? (list (check "f" "t" low) (check "f" "t" high)) (list low high))
    (for ([wrong (in-list (list (- low 1) (+ high 1) 1.0 +nan.0 #f "2" 3/2))])
      (check-equal? (refusal check "--flag" "text" wrong) (string-append "--flag text: " expected))))

  (check-equal? (check-size "f" "t" '(1 100000)) '(1 100000))
  (for ([wrong (in-list '((0 1) (1 0) (100001 1) (1 #f) (1) (1 2 3) #f 5 () (1.0 2.0)))])
    (check-equal? (refusal check-size "--size" "text" wrong)
                  "--size text: expected WIDTHxHEIGHT, two whole numbers from 1 to 100000"))

  (check-equal? (check-crop "--crop" #f '(64 36)) #f)
  (check-equal? (check-crop "--crop" "63,35,1,1" '(64 36)) '(63 35 1 1))
  (check-equal? (check-crop "--crop" "0,0,64,36" '(64 36)) '(0 0 64 36))
  (for ([wrong (in-list '("64,0,1,1" "0,36,1,1" "0,0,65,1" "0,0,1,37" "1,1,64,1" "0,0,0,1" "0,0,1,0"
                          "0,0,1" "0,0,1,1,1" "" "a,b,c,d" "-1,0,1,1" "0,0,1e1,1"))])
    (check-equal? (refusal check-crop "--crop" wrong '(64 36))
                  (format "--crop ~a: expected ~a" wrong
                          "X,Y,WIDTH,HEIGHT, four whole numbers that tell a part of 64x36")))

  ;; what does not fit into memory, and a part of it that does
  (check-equal? (refusal check-crop "--crop" #f '(100000 100000))
                "size 100000x100000: expected at most 268435456 pixels; --crop renders a part")
  (check-equal? (check-crop "--crop" #f '(16384 16384)) #f)
  (check-equal? (check-crop "--crop" "99000,99000,1000,1000" '(100000 100000))
                '(99000 99000 1000 1000))

  (check-equal? (check-name "--schedule" 'futures '(sequential futures)) 'futures)
  (check-equal? (refusal check-name "--schedule" 'x '(sequential futures))
                "--schedule x: expected one of sequential, futures"))
