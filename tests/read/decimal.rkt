#lang racket/base
;; Decimals from bytes: correctly rounded, by comparison with Racket's own reader (exact, 0 ulp).

(module+ test
  (require rackunit
           racket/flonum
           "../../private/read/decimal.rkt")

  (define (parse text)
    (define bytes (string->bytes/latin-1 text))
    (parse-decimal bytes 0 (bytes-length bytes)))

  (define (check-as-racket text)
    ;; Without a point or an exponent it would read an exact integer, which has no -0.
    (define inexact-text (if (regexp-match? #rx"[.e]" text) text (string-append text ".0")))
    (check-eqv? (parse text) (string->number inexact-text 10) text))

  (define random-source (make-pseudo-random-generator))
  (parameterize ([current-pseudo-random-generator random-source]) (random-seed 20240501))
  (define (pick n) (random n random-source))
  (define (digits n)
    (apply string-append (for/list ([_ (in-range n)]) (number->string (pick 10)))))

  (test-case "20000 random decimals of up to 40 digits"
    (for ([_ (in-range 20000)])
      (check-as-racket
       (string-append (vector-ref #("" "-" "+") (pick 3))
                      (digits (+ 1 (pick 20)))
                      (if (= 0 (pick 3)) "" (string-append "." (digits (+ 1 (pick 20)))))
                      (if (= 0 (pick 2)) "" (format "e~a" (- (pick 80) 40)))))))

  (test-case "5000 random flonums as written, single and double"
    (for ([_ (in-range 5000)])
      (define bits (apply bytes (for/list ([_ (in-range 8)]) (pick 256))))
      (for ([size (in-list '(4 8))])
        (define x (floating-point-bytes->real bits #f 0 size))
        (when (fl< (flabs x) +inf.0)
          (check-eqv? (parse (number->string x)) x)))))

  (test-case "ties and their neighbours, 1000 of them, exactly halfway between two flonums"
    (for ([_ (in-range 1000)])
      (define n (+ (expt 2 53) (* 2 (pick 1000000000)) 1))
      (check-eqv? (parse (number->string n)) (real->double-flonum n))
      (check-eqv? (parse (format "~a.000000000000000000000000000001" n))
                  (real->double-flonum (+ n 1)))
      (check-eqv? (parse (format "~a.999999999999999999999999999999" (- n 1)))
                  (real->double-flonum (- n 1)))))

  (test-case "the ends of the range"
    (for ([text (in-list '("4.9406564584124654e-324" "2.4703282292062327e-324"
                           "2.4703282292062328e-324" "2.2250738585072014e-308"
                           "2.2250738585072011e-308" "1.7976931348623157e308"
                           "1e-400" "-1e-400" "0e5" "-0" "0.000" "1e22" "1e23"
                           "9007199254740993" "9007199254740993.0000000000000000001"))])
      (check-as-racket text))
    (check-eqv? (parse "1.8e308") +inf.0)
    (check-eqv? (parse "-1e999999999999999999999999") -inf.0)
    (check-eqv? (parse "1e-999999999999999999999999") 0.0)
    (check-eqv? (parse (string-append "0." (make-string 100000 #\0) "1e100001")) 1.0)
    (check-eqv? (parse (string-append "1" (make-string 100000 #\0) "e-100000")) 1.0))

  (test-case "what is a number and what is not"
    (check-eqv? (parse ".5") 0.5)
    (check-eqv? (parse "5.") 5.0)
    (check-eqv? (parse "+3E+2") 300.0)
    (check-eqv? (parse "-Infinity") -inf.0)
    (check-eqv? (parse "inf") +inf.0)
    (check-eqv? (parse "nan") +nan.0)
    (check-eqv? (parse "-NaN") +nan.0)
    (for ([text (in-list '("" "." "-" "+-1" "1e" "1e+" "e5" "1.2.3" "0x10" "1,5" "1_0" "#e1" "1/2"
                           "nano" "1d5" "\u00e9"))])
      (check-false (parse text) text)))

  (test-case "integers"
    (define (integer text)
      (define bytes (string->bytes/latin-1 text))
      (parse-integer bytes 0 (bytes-length bytes)))
    (check-eqv? (integer "-12") -12)
    (check-eqv? (integer "+7") 7)
    (check-eqv? (integer "12345678901234567") 12345678901234567)
    (for ([text (in-list '("" "-" "1.0" "1e3" "123456789012345678" "x"))])
      (check-false (integer text) text))))
