#lang racket/base
;; Numbers from the bytes of a text: decimals correctly rounded to the nearest flonum, and integers.
;; The common cases never leave fixnum and flonum arithmetic; the others go through exact rationals.

(provide parse-decimal
         parse-integer)

(require racket/fixnum
         racket/flonum
         racket/math)

;; The flonum nearest to the decimal in bytes [start, end), ties to even; +nan.0 or an infinity for
;; nan, inf, infinity and for what is too large; #f when it is not a number.
;; Syntax: [+-] digits [. digits] [e [+-] digits], at least one digit before the exponent.
(define (parse-decimal bytes start end)
  (define negative? (and (fx< start end) (fx= (bytes-ref bytes start) minus)))
  (define first (if (and (fx< start end) (sign? (bytes-ref bytes start))) (fx+ start 1) start))
  ;; mantissa: the digits so far as a fixnum, significant of them without leading zeros;
  ;; scale: minus the number of digits after the point; digits: how many there were at all
  (let loop ([i first] [mantissa 0] [significant 0] [scale 0] [digits 0] [point? #f])
    (define b (if (fx< i end) (bytes-ref bytes i) 0))
    (cond
      [(digit? b)
       (define m (if (fx< significant 18) (fx+ (fx* 10 mantissa) (fx- b zero)) mantissa))
       (loop (fx+ i 1) m
             (if (fx= m 0) 0 (fx+ significant 1))
             (if point? (fx- scale 1) scale)
             (fx+ digits 1) point?)]
      [(and (fx= b dot) (not point?)) (loop (fx+ i 1) mantissa significant scale digits #t)]
      [(fx= digits 0) (parse-non-finite bytes first end negative?)]
      [else
       (define exponent
         (cond [(fx= i end) 0]
               [(or (fx= b 101) (fx= b 69)) (parse-exponent bytes (fx+ i 1) end)]
               [else #f]))
       (cond
         [(not exponent) #f]
         [else
          (define size
            (if (fx<= significant 18)
                (scale-decimal mantissa (fx+ scale exponent))
                (scale-long-decimal bytes first i (fx+ scale exponent))))
          (if negative? (fl* -1.0 size) size)])])))

;; The integer in bytes [start, end), at most 17 digits; #f when it is not one.
(define (parse-integer bytes start end)
  (define signed? (and (fx< start end) (sign? (bytes-ref bytes start))))
  (define first (if signed? (fx+ start 1) start))
  (and (fx< first end)
       (fx<= (fx- end first) 17)
       (let loop ([i first] [n 0])
         (cond
           [(fx= i end) (if (and signed? (fx= (bytes-ref bytes start) minus)) (fx- 0 n) n)]
           [(digit? (bytes-ref bytes i))
            (loop (fx+ i 1) (fx+ (fx* 10 n) (fx- (bytes-ref bytes i) zero)))]
           [else #f]))))

(define zero 48)
(define plus 43)
(define minus 45)
(define dot 46)
(define-syntax-rule (digit? b) (and (fx>= b zero) (fx<= b 57)))
(define-syntax-rule (sign? b) (or (fx= b minus) (fx= b plus)))

;; The exponent after the letter e, held within a million either way; #f when there is none.
(define (parse-exponent bytes start end)
  (define signed? (and (fx< start end) (sign? (bytes-ref bytes start))))
  (define first (if signed? (fx+ start 1) start))
  (and (fx< first end)
       (let loop ([i first] [n 0])
         (cond
           [(fx= i end) (if (and signed? (fx= (bytes-ref bytes start) minus)) (fx- 0 n) n)]
           [(digit? (bytes-ref bytes i))
            (loop (fx+ i 1) (fxmin 1000000 (fx+ (fx* 10 n) (fx- (bytes-ref bytes i) zero))))]
           [else #f]))))

(define (parse-non-finite bytes start end negative?)
  (define (word? text)
    (and (fx= (fx- end start) (string-length text))
         (string-ci=? text (bytes->string/latin-1 (subbytes bytes start end)))))
  (cond
    [(fx> (fx- end start) 8) #f]
    [(word? "nan") +nan.0]
    [(or (word? "inf") (word? "infinity")) (if negative? -inf.0 +inf.0)]
    [else #f]))

;; mantissa * 10^exponent, nearest flonum; 0 <= mantissa < 10^18.
;; Below 2^53 and with a power of ten that is a flonum, one operation rounds once (Clinger, How to
;; Read Floating Point Numbers Accurately, 1990). Up to 18 digits, the result is found as a sum of two
;; flonums whose error is bounded; it stands unless the bound straddles a rounding boundary.
(define (scale-decimal mantissa exponent)
  (cond
    [(fx= mantissa 0) 0.0]
    [(fx= exponent 0) (fx->fl mantissa)]
    [(or (fx> exponent 22) (fx< exponent -22)) (scale-exactly mantissa exponent)]
    [(fx<= mantissa 9007199254740992)
     (if (fx> exponent 0)
         (fl* (fx->fl mantissa) (flvector-ref powers-of-ten exponent))
         (fl/ (fx->fl mantissa) (flvector-ref powers-of-ten (fx- 0 exponent))))]
    [else
     (define high (fx->fl mantissa))
     (define low (fx->fl (fx- mantissa (fl->fx high))))
     (define power (flvector-ref powers-of-ten (fxabs exponent)))
     (cond
       [(fx> exponent 0)
        (define product (fl* high power))
        (round-sum product (product-error high power product) (fl* low power)
                   mantissa exponent)]
       [else
        (define quotient (fl/ high power))
        (define product (fl* quotient power))
        (define remainder (fl- (fl- high product) (product-error quotient power product)))
        (round-sum quotient (fl/ remainder power) (fl/ low power) mantissa exponent)])]))

;; big + (a + b), where a and b are each right to 2 roundings, or the exact path when in doubt.
(define (round-sum big a b mantissa exponent)
  (define small (fl+ a b))
  (define doubt (fl* 1e-15 (fl+ (flabs a) (flabs b))))
  (define below (fl+ big (fl- small doubt)))
  (define above (fl+ big (fl+ small doubt)))
  (if (fl= below above) below (scale-exactly mantissa exponent)))

;; x * y - product without error, for product = fl(x * y) (Dekker 1971).
(define (product-error x y product)
  (define x-scaled (fl* 134217729.0 x))
  (define x-high (fl- x-scaled (fl- x-scaled x)))
  (define x-low (fl- x x-high))
  (define y-scaled (fl* 134217729.0 y))
  (define y-high (fl- y-scaled (fl- y-scaled y)))
  (define y-low (fl- y y-high))
  (fl- (fl* x-low y-low)
       (fl- (fl- (fl- product (fl* x-high y-high)) (fl* x-low y-high)) (fl* x-high y-low))))

(define powers-of-ten
  (for/flvector #:length 23 ([k (in-range 23)]) (real->double-flonum (expt 10 k))))

;; More than 18 digits. No tie between flonums needs more than 767 digits, so the digits after the
;; 800th matter only by not being all zero.
(define (scale-long-decimal bytes start end exponent)
  (define most 800)
  (let loop ([i start] [mantissa 0] [significant 0] [skipped 0] [sticky? #f])
    (define b (if (fx< i end) (bytes-ref bytes i) dot))
    (cond
      [(fx= i end)
       (if sticky?
           (scale-exactly (+ (* 10 mantissa) 1) (fx+ exponent (fx- skipped 1)))
           (scale-exactly mantissa (fx+ exponent skipped)))]
      [(fx= b dot) (loop (fx+ i 1) mantissa significant skipped sticky?)]
      [(fx< significant most)
       (define m (+ (* 10 mantissa) (fx- b zero)))
       (loop (fx+ i 1) m (if (eqv? m 0) 0 (fx+ significant 1)) skipped sticky?)]
      [else
       (loop (fx+ i 1) mantissa significant (fx+ skipped 1) (or sticky? (not (fx= b zero))))])))

;; The same for any nonnegative integer. The size is bounded first: no power beyond 10^1200 is made.
(define (scale-exactly mantissa exponent)
  (define magnitude (if (eqv? mantissa 0) 0 (+ exponent (order-of-magnitude mantissa))))
  (cond
    [(eqv? mantissa 0) 0.0]
    [(> magnitude 309) +inf.0]
    [(< magnitude -325) 0.0]
    [else (real->double-flonum (* mantissa (expt 10 exponent)))]))
