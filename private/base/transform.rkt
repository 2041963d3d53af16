#lang typed/racket/base
;; Affine maps of space with their inverses: translations, scalings, rotations, shears, views, and
;; what they are composed of. Values; nothing changes one.
(require racket/list (for-syntax racket/base)
         "unsafe.rkt" "float3.rkt" "check.rkt" "matrix.rkt" "public.rkt")

(provide (struct-out Transform) Transform-matrix-rows
         make-Transform Transform-identity Transform-translate Transform-scale Transform-rotate
         Transform-shear Transform-look-at Transform-compose Transform-inverse
         Transform-point Transform-vector Transform-normal)

;; matrix, inverse-matrix: the first three rows of the 4 x 4 matrix of the map and of its inverse,
;; row by row, twelve numbers each; the last row is 0 0 0 1. The image of a point p is M p.
(struct Transform ([matrix : FlVector] [inverse-matrix : FlVector])
  #:transparent
  ;; the inverse follows from the matrix, up to how it was rounded
  #:property prop:equal+hash
  (list (lambda ([a : Transform] [b : Transform] [same? : (-> Any Any Boolean)])
          (same? (Transform-matrix a) (Transform-matrix b)))
        (lambda ([transform : Transform] [hash : (-> Any Integer)])
          (hash (Transform-matrix transform)))
        (lambda ([transform : Transform] [hash : (-> Any Integer)])
          (hash (Transform-entries transform))))
  #:property prop:custom-print-quotable 'never
  #:property prop:custom-write
  (lambda ([transform : Transform] [port : Output-Port] [mode : Any])
    (fprintf port "(Transform~a)"
             (apply string-append
                    (for/list : (Listof String) ([entry (in-list (Transform-entries transform))])
                      (format " ~a" entry))))))

(: Transform-entries (-> Transform (Listof Flonum)))
(define (Transform-entries transform)
  (for/list : (Listof Flonum) ([k (in-range 12)]) (flvector-ref (Transform-matrix transform) k)))

;; Transform-matrix-rows : the three rows of four numbers, as lists.
(: Transform-matrix-rows (-> Transform (Listof (Listof Flonum))))
(define (Transform-matrix-rows transform)
  (define entries (Transform-entries transform))
  (list (take entries 4) (take (drop entries 4) 4) (drop entries 8)))

;; --- constructors ---

;; make-Transform : the map with the matrix ((a b c d) (e f g h) (i j k l) (0 0 0 1)). Raises where
;; an entry is not finite, or the map flattens space so far that it has no inverse in flonums.
(: make-Transform (-> Real Real Real Real Real Real Real Real Real Real Real Real Transform))
(define (make-Transform . entries)
  (define matrix (list->flvector 'Transform entries))
  (Transform matrix (invert 'Transform matrix)))

(: list->flvector (-> Symbol (Listof Real) FlVector))
(define (list->flvector who entries)
  (apply flvector
         (for/list : (Listof Flonum) ([entry (in-list entries)])
           (check-finite who "entry" entry))))

(define-constructor Transform make-Transform (matrix inverse-matrix))

;; By cofactors, in rational arithmetic. A determinant within the rounding of its own terms is zero
;; for all one can tell from flonums.
(: invert (-> Symbol FlVector FlVector))
(define (invert who m)
  (define-syntax-rule (entry place) (inexact->exact (flvector-ref m place)))
  (define-values (a b c) (values (entry 0) (entry 1) (entry 2)))
  (define-values (d e f) (values (entry 4) (entry 5) (entry 6)))
  (define-values (g h k) (values (entry 8) (entry 9) (entry 10)))
  (define-syntax-rule (minor p q r s) (- (* p s) (* q r)))
  (define-values (aa ab ac) (values (minor e f h k) (minor c b k h) (minor b c e f)))
  (define-values (ba bb bc) (values (minor f d k g) (minor a c g k) (minor c a f d)))
  (define-values (ca cb cc) (values (minor d e g h) (minor b a h g) (minor a b d e)))
  (define determinant (+ (* a aa) (* b ba) (* c ca)))
  (define size
    (+ (* (abs a) (+ (abs (* e k)) (abs (* f h))))
       (* (abs b) (+ (abs (* f g)) (abs (* d k))))
       (* (abs c) (+ (abs (* d h)) (abs (* e g))))))
  (when (<= (* (abs determinant) (expt 2 50)) size)
    (raise-expected who "matrix" "a map that can be undone" m))
  (define-syntax-rule (quotient-of cofactor) (real->double-flonum (/ cofactor determinant)))
  (define inverse
    (with-translation-undone
     (linear (quotient-of aa) (quotient-of ab) (quotient-of ac)
             (quotient-of ba) (quotient-of bb) (quotient-of bc)
             (quotient-of ca) (quotient-of cb) (quotient-of cc))
     m))
  (unless (all-finite? inverse)
    (raise-expected who "matrix" "a map that can be undone" m))
  inverse)

;; An inverse's linear part completed by the translation that undoes that of m.
(: with-translation-undone (-> FlVector FlVector FlVector))
(define (with-translation-undone linear m)
  (define undone (Float3-negate (matrix-vector linear 0 (matrix-origin m 0))))
  (define-syntax-rule (at k) (flvector-ref linear k))
  (flvector (at 0) (at 1) (at 2) (Float3-x undone)
            (at 4) (at 5) (at 6) (Float3-y undone)
            (at 8) (at 9) (at 10) (Float3-z undone)))

(: all-finite? (-> FlVector Boolean))
(define (all-finite? m)
  (for/and : Boolean ([k : Nonnegative-Fixnum (in-range 12)])
    (fl< (flabs (flvector-ref m k)) +inf.0)))

;; A Transform from both matrices, checked: finite products of finite factors may overflow.
(: checked (-> Symbol FlVector FlVector Transform))
(define (checked who matrix inverse)
  (unless (and (all-finite? matrix) (all-finite? inverse))
    (raise-expected who "matrix" "a map that can be undone" matrix))
  (Transform matrix inverse))

(: linear (-> Flonum Flonum Flonum Flonum Flonum Flonum Flonum Flonum Flonum FlVector))
(define (linear a b c d e f g h k)
  (flvector a b c 0.0 d e f 0.0 g h k 0.0))

;; Transform-identity : the map that leaves everything where it is.
(: Transform-identity (-> Transform))
(define (Transform-identity)
  (define matrix (linear 1.0 0.0 0.0 0.0 1.0 0.0 0.0 0.0 1.0))
  (Transform matrix matrix))

;; Transform-translate : moves by a vector, or by three numbers.
(: Transform-translate (case-> (-> Float3 Transform) (-> Real Real Real Transform)))
(define Transform-translate
  (case-lambda
    [([x : Real] [y : Real] [z : Real]) (Transform-translate (make-Float3 x y z))]
    [([offset : Float3])
     (check-point 'Transform-translate "offset" offset)
     (define-values (x y z) (values (Float3-x offset) (Float3-y offset) (Float3-z offset)))
     (Transform (flvector 1.0 0.0 0.0 x 0.0 1.0 0.0 y 0.0 0.0 1.0 z)
                (flvector 1.0 0.0 0.0 (fl- 0.0 x) 0.0 1.0 0.0 (fl- 0.0 y)
                          0.0 0.0 1.0 (fl- 0.0 z)))]))

;; Transform-scale : stretches from the origin by one factor, or by one along each axis. Negative
;; factors mirror; zero raises.
(: Transform-scale (case-> (-> Real Transform) (-> Real Real Real Transform)))
(define Transform-scale
  (case-lambda
    [([factor : Real]) (Transform-scale factor factor factor)]
    [([x : Real] [y : Real] [z : Real])
     (define (check [factor : Real])
       (define value (check-finite 'Transform-scale "factor" factor))
       (if (fl< (flabs (fl/ 1.0 value)) +inf.0)
           value
           (raise-expected 'Transform-scale "factor" "a number other than zero" factor)))
     (define-values (a b c) (values (check x) (check y) (check z)))
     (Transform (linear a 0.0 0.0 0.0 b 0.0 0.0 0.0 c)
                (linear (fl/ 1.0 a) 0.0 0.0 0.0 (fl/ 1.0 b) 0.0 0.0 0.0 (fl/ 1.0 c)))]))

;; Transform-rotate : turns about an axis through the origin, counter-clockwise as seen from the
;; axis's tip, by an angle in radians or by #:degrees; multiples of 90 degrees are exact.
;; Raises for an axis without direction and unless one angle is given. (Rodrigues' formula.)
(: Transform-rotate (->* (Float3) ((U #f Real) #:degrees (U #f Real)) Transform))
(define (Transform-rotate axis [radians #f] #:degrees [degrees #f])
  (check-direction 'Transform-rotate "axis" axis)
  (define-values (sine cosine)
    (cond
      [(and radians (not degrees))
       (define angle (check-finite 'Transform-rotate "angle" radians))
       (values (flsin angle) (flcos angle))]
      [(and degrees (not radians))
       (sine-and-cosine-degrees (check-finite 'Transform-rotate "#:degrees" degrees))]
      [else (raise-expected 'Transform-rotate "angle" "radians or #:degrees" radians)]))
  (define unit (Float3-normalized/checked axis))
  (define-values (x y z) (values (Float3-x unit) (Float3-y unit) (Float3-z unit)))
  (define rest (fl- 1.0 cosine))
  (define-syntax-rule (diagonal a) (fl+ cosine (fl* rest (fl* a a))))
  (define-syntax-rule (plus a b c) (fl+ (fl* rest (fl* a b)) (fl* sine c)))
  (define-syntax-rule (minus a b c) (fl- (fl* rest (fl* a b)) (fl* sine c)))
  (Transform (linear (diagonal x) (minus x y z) (plus x z y)
                     (plus x y z) (diagonal y) (minus y z x)
                     (minus x z y) (plus y z x) (diagonal z))
             (linear (diagonal x) (plus x y z) (minus x z y)
                     (minus x y z) (diagonal y) (plus y z x)
                     (plus x z y) (minus y z x) (diagonal z))))

;; Sine and cosine of an angle in degrees, reduced exactly to within 45 degrees of a right angle.
(: sine-and-cosine-degrees (-> Flonum (Values Flonum Flonum)))
(define (sine-and-cosine-degrees degrees)
  (define exact (inexact->exact degrees))
  (define quarter (round (/ exact 90)))
  (define rest
    (fl* (real->double-flonum (- exact (* 90 quarter))) 0.017453292519943295))
  (define-values (s c) (values (flsin rest) (flcos rest)))
  (case (modulo quarter 4)
    [(0) (values s c)]
    [(1) (values c (fl- 0.0 s))]
    [(2) (values (fl- 0.0 s) (fl- 0.0 c))]
    [else (values (fl- 0.0 c) s)]))

;; Transform-shear : moves each coordinate in proportion to the others: #:x-by-y is how far x moves
;; for each unit of y, and so on. Raises where that flattens space.
(: Transform-shear (->* () (#:x-by-y Real #:x-by-z Real #:y-by-x Real #:y-by-z Real
                            #:z-by-x Real #:z-by-y Real)
                        Transform))
(define (Transform-shear #:x-by-y [xy 0.0] #:x-by-z [xz 0.0] #:y-by-x [yx 0.0] #:y-by-z [yz 0.0]
                         #:z-by-x [zx 0.0] #:z-by-y [zy 0.0])
  (define matrix
    (list->flvector 'Transform-shear (list 1.0 xy xz 0.0 yx 1.0 yz 0.0 zx zy 1.0 0.0)))
  (Transform matrix (invert 'Transform-shear matrix)))

;; Transform-look-at : places what was made at the origin, looking along -z with its top towards
;; +y, at `eye`, so that it looks at `focus` with its top towards `up`. Its inverse is the usual
;; view matrix. Raises where the three do not give a direction each.
(: Transform-look-at (->* (Float3 Float3) (Float3) Transform))
(define (Transform-look-at eye focus [up (make-Float3 0 1 0)])
  (check-point 'Transform-look-at "eye" eye)
  (check-point 'Transform-look-at "focus" focus)
  (define backward
    (Float3-normalized/checked
     (check-direction 'Transform-look-at "eye - focus" (Float3-subtract eye focus))))
  (define aside
    (Float3-cross (Float3-normalized/checked (check-direction 'Transform-look-at "up" up))
                  backward))
  (unless (fl> (Float3-length aside) 1e-12)
    (raise-expected 'Transform-look-at "up" "a direction across the line of sight" up))
  (define right (Float3-normalized/checked aside))
  (define top (Float3-normalized/checked (Float3-cross backward right)))
  (define matrix
    (flvector (Float3-x right) (Float3-x top) (Float3-x backward) (Float3-x eye)
              (Float3-y right) (Float3-y top) (Float3-y backward) (Float3-y eye)
              (Float3-z right) (Float3-z top) (Float3-z backward) (Float3-z eye)))
  (checked 'Transform-look-at matrix
           (with-translation-undone
            (linear (Float3-x right) (Float3-y right) (Float3-z right)
                    (Float3-x top) (Float3-y top) (Float3-z top)
                    (Float3-x backward) (Float3-y backward) (Float3-z backward))
            matrix)))

;; Transform-compose : does the last map first, as (a (b (c point))).
(: Transform-compose (-> Transform * Transform))
(define (Transform-compose . transforms)
  (for/fold ([outer : Transform (Transform-identity)]) ([inner (in-list transforms)])
    (checked 'Transform-compose
             (matrix-product (Transform-matrix outer) (Transform-matrix inner))
             (matrix-product (Transform-inverse-matrix inner) (Transform-inverse-matrix outer)))))

;; Transform-inverse : the map that undoes it.
(: Transform-inverse (-> Transform Transform))
(define (Transform-inverse transform)
  (Transform (Transform-inverse-matrix transform) (Transform-matrix transform)))

;; Transform-point, -vector, -normal : the image of a point; of a direction, with its length; and
;; the unit normal of the image of a surface (by the inverse transpose).
(: Transform-point (-> Transform Float3 Float3))
(define (Transform-point transform point) (matrix-point (Transform-matrix transform) 0 point))

(: Transform-vector (-> Transform Float3 Float3))
(define (Transform-vector transform vector) (matrix-vector (Transform-matrix transform) 0 vector))

(: Transform-normal (-> Transform Float3 Float3))
(define (Transform-normal transform normal)
  (Float3-normalized/checked (matrix-normal (Transform-inverse-matrix transform) 0 normal)))
