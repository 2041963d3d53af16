#lang racket/base
;; Polygons into triangles: a fan when convex, else ear clipping in the polygon's plane (ElGindy,
;; Everett, Toussaint, Slicing an ear using prune-and-search, 1993, for what may change at a clip).

(provide triangulate-polygon)

(require racket/fixnum
         racket/flonum
         "growable.rkt"
         "orientation.rkt")

;; Calls (emit! i j k) with corners, numbers from 0 to count - 1 in the polygon's own sense, for each
;; of the count - 2 triangles. Corner k is vertex (fxvector-ref vertices k), 3 coordinates each in
;; positions. Returns 'simple, 'crossing when no triangulation exists because the outline crosses or
;; touches itself (the rest is then a fan), or 'intricate when the search was given up.
(define (triangulate-polygon positions vertices count emit!)
  (cond
    [(fx= count 3) (emit! 0 1 2) 'simple]
    [else
     (define-values (xs ys) (project positions vertices count))
     (cond
       [(strictly-convex? xs ys count)
        (for ([k (in-range 2 count)])
          (emit! 0 (fx- k 1) k))
        'simple]
       [else (clip-ears xs ys count emit!)])]))

;; The corners in the plane, counterclockwise: the coordinate along which Newell's normal is largest
;; is left out, so that what remains is exact.
(define (project positions vertices count)
  (define (coordinate k axis)
    (flvector-ref positions (fx+ axis (fx* 3 (fxvector-ref vertices k)))))
  (define largest
    (for*/fold ([m 0.0]) ([k (in-range count)] [axis (in-range 3)])
      (flmax m (flabs (coordinate k axis)))))
  (define scale (flmin 1e307 (fl/ 0.5 largest)))
  (define (relative k axis)
    (fl- (fl* scale (coordinate k axis)) (fl* scale (coordinate 0 axis))))
  (define (area u v)
    (for/fold ([sum 0.0]) ([k (in-range 1 (fx- count 1))])
      (fl+ sum (fl- (fl* (relative k u) (relative (fx+ k 1) v))
                    (fl* (relative k v) (relative (fx+ k 1) u))))))
  (define-values (nx ny nz) (values (area 1 2) (area 2 0) (area 0 1)))
  (define-values (u v normal)
    (cond
      [(and (fl>= (flabs nx) (flabs ny)) (fl>= (flabs nx) (flabs nz))) (values 1 2 nx)]
      [(fl>= (flabs ny) (flabs nz)) (values 2 0 ny)]
      [else (values 0 1 nz)]))
  (define (along axis)
    (for/flvector #:length count ([k (in-range count)]) (coordinate k axis)))
  (if (fl< normal 0.0)
      (values (along v) (along u))
      (values (along u) (along v))))

(define (strictly-convex? xs ys count)
  (for/and ([k (in-range count)])
    (fx= 1 (turn xs ys k (fxmodulo (fx+ k 1) count) (fxmodulo (fx+ k 2) count)))))

;; 1 for a left turn at b on the way from a to c, -1 for a right turn, 0 for none.
(define (turn xs ys a b c)
  (orientation (flvector-ref xs a) (flvector-ref ys a)
               (flvector-ref xs b) (flvector-ref ys b)
               (flvector-ref xs c) (flvector-ref ys c)))

;; A corner is an ear when it turns left and no other corner lies in its triangle. It is enough to
;; look at the corners that do not turn left, and after a clip only the two neighbours can become
;; ears: they wait in a queue.
(define (clip-ears xs ys count emit!)
  (define next (make-fxvector count))
  (define previous (make-fxvector count))
  (for ([k (in-range count)])
    (fxvector-set! next k (fxmodulo (fx+ k 1) count))
    (fxvector-set! previous k (fxmodulo (fx+ k (fx- count 1)) count)))
  (define (left-turn? k)
    (fx= 1 (turn xs ys (fxvector-ref previous k) k (fxvector-ref next k))))
  (define blockers (make-blockers xs ys count (λ (k) (not (left-turn? k)))))
  (define clipped (make-bytes count 0))
  (define queue (make-fixnums))
  (for ([k (in-range count)])
    (fixnums-push! queue k))
  (define (ear? k)
    (and (left-turn? k)
         (not (blocked? blockers (fxvector-ref previous k) k (fxvector-ref next k)))))
  (define (clip! k)
    (define a (fxvector-ref previous k))
    (define c (fxvector-ref next k))
    (emit! a k c)
    (bytes-set! clipped k 1)
    (fxvector-set! next a c)
    (fxvector-set! previous c a)
    (for ([neighbour (in-list (list a c))])
      (when (left-turn? neighbour) (unblock! blockers neighbour))
      (fixnums-push! queue neighbour)))
  (define most-steps (fx+ 1000000 (fx* 3000 count)))
  (let loop ([head 0] [left count] [left-at-scan count])
    (cond
      [(fx> (fx+ head (blockers-steps blockers)) most-steps) 'intricate]
      [(fx= head (fixnums-count queue))
       (define rest (for/list ([k (in-range count)] #:when (fx= 0 (bytes-ref clipped k))) k))
       (cond
         [(fx= left 3)
          (apply emit! rest)
          (if (fx= -1 (turn xs ys (car rest) (cadr rest) (caddr rest))) 'crossing 'simple)]
         [(fx= left left-at-scan)
          (for ([j (in-list (cdr rest))] [k (in-list (cddr rest))])
            (emit! (car rest) j k))
          'crossing]
         [else
          (for ([k (in-list rest)]) (fixnums-push! queue k))
          (loop head left left)])]
      [else
       (define k (fxvector-ref (fixnums-data queue) head))
       (cond
         [(and (fx> left 3) (fx= 0 (bytes-ref clipped k)) (ear? k))
          (clip! k)
          (loop (fx+ head 1) (fx- left 1) left-at-scan)]
         [else (loop (fx+ head 1) left left-at-scan)])])))

;; The corners that do not turn left, in a grid of about one cell each: cell i starts the chain
;; (fxvector-ref heads i), -1 ends it; the chain in the last slot of heads holds all of them.
;; Corners that came to turn left are unlinked when next met.
(struct blockers (xs ys active size left bottom right top heads links all-links
                     [count #:mutable] [steps #:mutable])
  #:authentic)

(define (make-blockers xs ys count blocks?)
  (define active (make-bytes count 0))
  (define total
    (for/fold ([n 0]) ([k (in-range count)])
      (cond [(blocks? k) (bytes-set! active k 1) (fx+ n 1)]
            [else n])))
  (define size (fxmax 1 (fl->fx (flfloor (flsqrt (fx->fl total))))))
  (define-values (left right bottom top)
    (for/fold ([left +inf.0] [right -inf.0] [bottom +inf.0] [top -inf.0])
              ([x (in-flvector xs)] [y (in-flvector ys)])
      (values (flmin left x) (flmax right x) (flmin bottom y) (flmax top y))))
  (define heads (make-fxvector (fx+ 1 (fx* size size)) -1))
  (define b (blockers xs ys active size left bottom right top heads
                      (make-fxvector count -1) (make-fxvector count -1) total 0))
  (define (link! links head k)
    (fxvector-set! links k (fxvector-ref heads head))
    (fxvector-set! heads head k))
  (for ([k (in-range count)] #:when (fx= 1 (bytes-ref active k)))
    (link! (blockers-links b) (fx+ (column b (flvector-ref xs k))
                                   (fx* size (row b (flvector-ref ys k)))) k)
    (link! (blockers-all-links b) (fx* size size) k))
  b)

(define (column b x) (slice x (blockers-left b) (blockers-right b) (blockers-size b)))
(define (row b y) (slice y (blockers-bottom b) (blockers-top b) (blockers-size b)))

;; Which of size slices of [low, high] the coordinate falls in; rises with it.
(define (slice x low high size)
  (define t (fl* (fx->fl size) (fl/ (fl- x low) (fl- high low))))
  (cond [(fl>= t (fx->fl size)) (fx- size 1)]
        [(fl>= t 0.0) (fl->fx (flfloor t))]
        [else 0]))

(define (unblock! b k)
  (when (fx= 1 (bytes-ref (blockers-active b) k))
    (bytes-set! (blockers-active b) k 0)
    (set-blockers-count! b (fx- (blockers-count b) 1))))

;; Does a blocker lie in the closed triangle i j k, other than at one of its corners?
(define (blocked? b i j k)
  (define xs (blockers-xs b))
  (define ys (blockers-ys b))
  (define-values (ix iy) (values (flvector-ref xs i) (flvector-ref ys i)))
  (define-values (jx jy) (values (flvector-ref xs j) (flvector-ref ys j)))
  (define-values (kx ky) (values (flvector-ref xs k) (flvector-ref ys k)))
  (define-values (left right) (values (flmin ix (flmin jx kx)) (flmax ix (flmax jx kx))))
  (define-values (bottom top) (values (flmin iy (flmin jy ky)) (flmax iy (flmax jy ky))))
  (define (inside? p)
    (define x (flvector-ref xs p))
    (define y (flvector-ref ys p))
    (and (fl<= left x) (fl<= x right) (fl<= bottom y) (fl<= y top)
         (not (and (fl= x ix) (fl= y iy)))
         (not (and (fl= x jx) (fl= y jy)))
         (not (and (fl= x kx) (fl= y ky)))
         (fx>= (orientation ix iy jx jy x y) 0)
         (fx>= (orientation jx jy kx ky x y) 0)
         (fx>= (orientation kx ky ix iy x y) 0)))
  (define size (blockers-size b))
  (define-values (first-column last-column) (values (column b left) (column b right)))
  (define-values (first-row last-row) (values (row b bottom) (row b top)))
  (define cells (fx* (fx+ 1 (fx- last-column first-column)) (fx+ 1 (fx- last-row first-row))))
  (if (fx>= cells (blockers-count b))
      (chain-any? b (blockers-all-links b) (fx* size size) inside?)
      (for*/or ([r (in-range first-row (fx+ 1 last-row))]
                [c (in-range first-column (fx+ 1 last-column))])
        (chain-any? b (blockers-links b) (fx+ c (fx* size r)) inside?))))

;; Is there an active corner of this chain for which (inside? corner) holds?
(define (chain-any? b links head inside?)
  (define heads (blockers-heads b))
  (define active (blockers-active b))
  (let walk ([before -1] [p (fxvector-ref heads head)] [steps 1])
    (define (done result)
      (set-blockers-steps! b (fx+ steps (blockers-steps b)))
      result)
    (cond
      [(fx< p 0) (done #f)]
      [(fx= 0 (bytes-ref active p))
       (define after (fxvector-ref links p))
       (if (fx< before 0)
           (fxvector-set! heads head after)
           (fxvector-set! links before after))
       (walk before after (fx+ steps 1))]
      [(inside? p) (done #t)]
      [else (walk p (fxvector-ref links p) (fx+ steps 1))])))
