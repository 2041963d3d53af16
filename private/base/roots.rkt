#lang typed/racket/base
;; Real roots for ray intersection: quadratics with an exact discriminant, slabs, and quartics
;; bracketed by the roots of their derivative. The let- forms are for kernels and allocate nothing.
(require "unsafe.rkt")

(provide quadratic-roots depressed-quartic-roots
         let-quadratic-roots let-roots-of-discriminant let-slab
         find-sign-change)

;; a b - c d to within two units in the last place, as long as no product leaves the range
;; 1e-290 to 1e290 (Dekker, "A floating-point technique for extending the available precision",
;; 1971, with Veltkamp's splitting, since there is no fused multiply-add).
(define-syntax-rule (difference-of-products a b c d)
  (let-product (product product-error) (a b)
    (let-product (other other-error) (c d)
      (fl+ (fl- product other) (fl- product-error other-error)))))

;; Binds a b rounded and what the rounding took.
(define-syntax-rule (let-product (product product-error) (a b) body)
  (let* ([x a] [y b]
         [product (fl* x y)]
         [x-split (fl* x (SPLITTER))] [x-high (fl- x-split (fl- x-split x))] [x-low (fl- x x-high)]
         [y-split (fl* y (SPLITTER))] [y-high (fl- y-split (fl- y-split y))] [y-low (fl- y y-high)]
         [product-error (fl+ (fl* x-low y-low)
                             (fl+ (fl* x-low y-high)
                                  (fl+ (fl* x-high y-low)
                                       (fl- (fl* x-high y-high) product))))])
    body))

;; 2^27 + 1: splits 53 bits into two halves.
(define-syntax-rule (SPLITTER) 134217729.0)

;; Binds low <= high to the roots of a t^2 + 2 b t + c, whose b^2 - a c is already known to be the
;; discriminant and not negative. The larger root in magnitude is taken first and the other from
;; the product of both, so that neither cancels. Where a = 0 the root that is missing is infinite;
;; where b = 0 too, both are NaN.
(define-syntax-rule (let-roots-of-discriminant (low high) (a b c discriminant) body ...)
  (let* ([half-b b]
         [s (flsqrt discriminant)]
         [q (fl* -1.0 (if (fl< half-b 0.0) (fl- half-b s) (fl+ half-b s)))]
         [first-root (fl/ q a)]
         [second-root (if (fl= q 0.0) first-root (fl/ c q))]
         [low (if (fl< second-root first-root) second-root first-root)]
         [high (if (fl< second-root first-root) first-root second-root)])
    body ...))

;; The same from the coefficients alone; `none` where the discriminant is negative. Coefficients
;; and their products must stay within 1e-290 to 1e290; quadratic-roots scales them.
(define-syntax-rule (let-quadratic-roots (low high) (a b c) found none)
  (let* ([discriminant (difference-of-products b b a c)])
    (if (fl>= discriminant 0.0)
        (let-roots-of-discriminant (low high) (a b c discriminant) found)
        none)))

;; Binds enter <= leave to the parameters between which low <= o + t d <= high, both infinite
;; where d = 0 and o is between; `none` where it is not.
(define-syntax-rule (let-slab (enter leave) (o d low high) found none)
  (let* ([parallel? (fl= d 0.0)])
    (if (and parallel? (or (fl< o low) (fl> o high)))
        none
        (let* ([inverse (fl/ 1.0 d)]
               [to-low (if parallel? -inf.0 (fl* (fl- low o) inverse))]
               [to-high (if parallel? +inf.0 (fl* (fl- high o) inverse))]
               [enter (if (fl< inverse 0.0) to-high to-low)]
               [leave (if (fl< inverse 0.0) to-low to-high)])
          found))))

;; Finds the next change of sign of a function that has the sign of the quartic
;; t^4 + 2 p t^2 + 4 q t + s, between `from`, where its value is from-value, and `high`, where it is
;; taken as high-value, which is not negative. (evaluate t (value slope) body) binds the function
;; and its derivative at t; what has the quartic's sign but not its cancellation may stand in for it.
;;
;; Between two extremes there is at most one change, so roots are never missed singly and a line
;; from outside meets an even number. The extremes are roots of t^3 + p t + q, at most one in each
;; of the pieces that its own extremes and its inflection cut; in a piece Newton's iteration from
;; the end where cubic and curvature agree in sign runs monotonically to the root. `piece` (0 to 4)
;; is the first piece not yet passed. `found` sees the root and from where to go on: next-piece,
;; next-from and next-value.
(define-syntax-rule
  (find-sign-change (evaluate) (p q) (piece from from-value) (high high-value)
                    #:found (root next-piece next-from next-value) found
                    #:none none)
  (let* ([turn (if (fl< p 0.0) (flsqrt (fl* p (fl/ -1.0 3.0))) 0.0)]
         [span (fl+ (flabs from) (flabs high))]
         [extreme-tolerance (fl* span (EXTREME-TOLERANCE))]
         [root-tolerance (fl* span (ROUNDING))])
    (let walk ([at : Fixnum piece] [start : Flonum from] [start-value : Flonum from-value])
      ;; Newton inside a bracket, halved where a step leaves it or does not halve the last one; the
      ;; first guess from a parabola whose turning point is an end of the bracket
      (define-syntax-rule (refine next-piece* end end-value turning)
        (let* ([next-piece next-piece*] [next-from end] [next-value end-value]
               [rising? (fl< start-value 0.0)]
               [first-guess (parabola-root turning start start-value next-from next-value)])
          (let refining ([low : Flonum start] [up : Flonum next-from]
                         [t : Flonum first-guess] [last-step : Flonum 0.0])
            (evaluate t (value slope)
              (let* ([before? (eq? rising? (fl< value 0.0))]
                     [low* (if before? t low)]
                     [up* (if before? up t)]
                     [newton (fl- t (fl/ value slope))]
                     [newton-step (fl- newton t)]
                     [good? (and (fl>= newton low*) (fl<= newton up*)
                                 (or (fl= last-step 0.0)
                                     (fl<= (flabs newton-step) (fl* 0.5 (flabs last-step)))))]
                     [next (if (fl= value 0.0) t (if good? newton (fl* 0.5 (fl+ low* up*))))]
                     [step (fl- next t)])
                ;; between neighbouring numbers Newton would go to and fro
                (if (and (or good? (and (fl< low* next) (fl< next up*)))
                         (improvable? step (if good? last-step 0.0) root-tolerance span))
                    (refining low* up* next (if good? step 0.0))
                    (let ([root (fl+ next 0.0)]) found)))))))
      (cond
        [(fx< at 4)
         (let* ([piece-low (if (fx< at 2) (if (fx= at 0) -inf.0 (fl* -1.0 turn))
                               (if (fx= at 2) 0.0 turn))]
                [piece-high (if (fx< at 2) (if (fx= at 0) (fl* -1.0 turn) 0.0)
                                (if (fx= at 2) turn +inf.0))]
                [left (if (fl< piece-low start) start piece-low)]
                [right (if (fl< high piece-high) high piece-high)])
           (if (fl< left right)
               (let* ([falling-at-left? (fl< (cubic p q left) 0.0)]
                      [falling-at-right? (fl< (cubic p q right) 0.0)])
                 (if (eq? falling-at-left? falling-at-right?)
                     (walk (fx+ at 1) start start-value)
                     (let* ([good-left? (eq? (fx< at 2) falling-at-left?)]
                            [good-end (if good-left? left right)])
                       (let climbing ([t : Flonum good-end] [last-step : Flonum 0.0])
                         (let* ([next (fl- t (fl/ (cubic p q t) (fl+ (fl* 3.0 (fl* t t)) p)))]
                                [kept (if (fl>= next left) (if (fl<= next right) next right) left)]
                                [step (fl- kept t)])
                           (if (improvable? step last-step extreme-tolerance span)
                               (climbing kept step)
                               (evaluate kept (value slope)
                                 (if (eq? (fl< value 0.0) (fl< start-value 0.0))
                                     (walk (fx+ at 1) kept value)
                                     (refine (fx+ at 1) kept value kept)))))))))
               (walk (fx+ at 1) start start-value)))]
        [(and (fx= at 4) (fl< start-value 0.0))
         (refine 5 high high-value start)]
        [else none]))))

;; Whether a Newton step may leave an error above the tolerance. The error after a step is the
;; step's square times a factor: the one that last-step (0 where none came before) shows, and by
;; a lucky step too small, so that 2^10 times it and 2^6 over the interval's span are allowed for.
(define-syntax-rule (improvable? step last-step tolerance span)
  (let* ([square (fl* step step)])
    (and (fl> (flabs step) tolerance)
         (or (fl> (fl* 64.0 square) (fl* tolerance span))
             (fl> (fl* 1024.0 (fl* (flabs step) square))
                  (fl* tolerance (fl* last-step last-step)))))))

;; The root between start and end, where the values differ in sign, of the parabola through both
;; that turns at `turning`, one of them.
(define-syntax-rule (parabola-root turning start start-value end end-value)
  (let* ([turning-at-end? (fl= turning end)]
         [turning-value (if turning-at-end? end-value start-value)]
         [other (if turning-at-end? start end)]
         [other-value (if turning-at-end? start-value end-value)])
    (fl+ turning (fl* (fl- other turning)
                      (flsqrt (fl/ turning-value (fl- turning-value other-value)))))))

(define-syntax-rule (cubic p q t)
  (fl+ (fl* (fl+ (fl* t t) p) t) q))

;; An extreme only separates roots; a root is wanted to the last bit.
(define-syntax-rule (EXTREME-TOLERANCE) 2.3283064365386963e-10) ; 2^-32
(define-syntax-rule (ROUNDING) 1.1102230246251565e-16) ; 2^-53

;; The real roots of a t^2 + b t + c in ascending order, a double root twice: '(), one where a = 0,
;; or two; '() where a = b = 0. Coefficients: any finite numbers; they are scaled by powers of two,
;; so nothing overflows but a root that is itself beyond the range of doubles, which is left out.
;; Within 8 ulp where b^2 and 4 a c differ by more than a part in 1e12.
(: quadratic-roots (-> Flonum Flonum Flonum (Listof Flonum)))
(define (quadratic-roots a b c)
  (cond
    [(fl= a 0.0) (if (fl= b 0.0) '() (finite (list (ratio c b))))]
    [(fl= c 0.0) (ascending 0.0 (ratio b a))]
    [else
     ;; t = 2^k u makes the outer coefficients alike, another factor brings all near 1
     (define k (flfloor (fl* 0.5 (fl- (exponent c) (exponent a)))))
     (define outer (flmax (exponent c) (fl+ (exponent a) (fl* 2.0 k))))
     (define middle (if (fl= b 0.0) -inf.0 (fl+ (exponent b) k)))
     (cond
       ;; a c is nothing beside b^2
       [(fl> (fl- middle outer) 100.0)
        (ascending (ratio b a) (ratio c b))]
       [else
        (define unit (fl* -1.0 (flmax outer middle)))
        (define a* (shifted a (fl+ unit (fl* 2.0 k))))
        (define half-b* (fl* 0.5 (shifted b (fl+ unit k))))
        (define c* (shifted c unit))
        (let-quadratic-roots (low high) (a* half-b* c*)
          (finite (list (shifted low k) (shifted high k)))
          '())])]))

(: ascending (-> Flonum Flonum (Listof Flonum)))
(define (ascending x y) (finite (if (fl<= x y) (list x y) (list y x))))

(: finite (-> (Listof Flonum) (Listof Flonum)))
(define (finite roots) (filter (lambda ([t : Flonum]) (fl< (flabs t) +inf.0)) roots))

;; - x / y, and 0.0 for both zeros.
(: ratio (-> Flonum Flonum Flonum))
(define (ratio x y) (fl+ 0.0 (fl* -1.0 (fl/ x y))))

;; floor(log2 |x|), give or take one.
(: exponent (-> Flonum Flonum))
(define (exponent x) (flfloor (fl/ (fllog (flabs x)) (fllog 2.0))))

;; x 2^n for a whole n of any size.
(: shifted (-> Flonum Flonum Flonum))
(define (shifted x n)
  (cond
    [(fl> n 900.0) (shifted (fl* x (flexpt 2.0 900.0)) (fl- n 900.0))]
    [(fl< n -900.0) (shifted (fl* x (flexpt 2.0 -900.0)) (fl+ n 900.0))]
    [else (fl* x (flexpt 2.0 n))]))

;; The real roots of t^4 + p t^2 + q t + s between low and high in ascending order, where the
;; quartic is not negative at low and high. (Any quartic has this form after a shift of t.) Between
;; extremes by safeguarded Newton, not by Ferrari's formula, which loses half of the digits near
;; double roots. A double root at a maximum counts twice, at a minimum not at all.
(: depressed-quartic-roots (-> Flonum Flonum Flonum Flonum Flonum (Listof Flonum)))
(define (depressed-quartic-roots p q s low high)
  (define-syntax-rule (evaluate t (value slope) body)
    (let* ([value (fl+ (fl* (fl+ (fl* (fl+ (fl* t t) p) t) q) t) s)]
           [slope (fl+ (fl* (fl+ (fl* 4.0 (fl* t t)) (fl* 2.0 p)) t) q)])
      body))
  (define-syntax-rule (value-at t) (evaluate t (value slope) value))
  (define half-p (fl* 0.5 p))
  (define quarter-q (fl* 0.25 q))
  (let more ([piece : Fixnum 0] [from : Flonum low] [from-value : Flonum (flmax 0.0 (value-at low))])
    (find-sign-change (evaluate) (half-p quarter-q) (piece from from-value)
                      (high (flmax 0.0 (value-at high)))
      #:found (root next-piece next-from next-value)
      (cons root (more next-piece next-from next-value))
      #:none '())))
