#lang typed/racket/base
;; Triangles to samples: clipping in homogeneous coordinates, vertices on a grid of parts of a pixel,
;; and edge functions in whole numbers, so that triangles that share an edge share no sample and miss
;; none (the top-left rule); the nearest triangle of each sample stays (z-buffer).
(require "../base/unsafe.rkt" "../base/float3.rkt")

(provide (struct-out Canvas) make-Canvas Canvas-forget-surfaces! draw-mesh! draw-polygon! put-if-nearer!)

;; A band of a picture: its rows from `top`, its columns from `left`, in a film of film-width by
;; film-height pixels. offsets: where in a pixel its samples are, two numbers of subpixels each.
;; keys: for each sample how near its surface is (greater is nearer), which is linear over the
;; picture: the reciprocal of the distance along the line of sight, or less that distance where the
;; view is orthographic. ids: number of the surface, -1 for none. Samples of a pixel lie together.
;; subpixels: parts of a pixel's side, a power of two. scratch: corners of polygons being clipped.
;; slack: how many pixels aside a surface may be for lines on it to count as nearer than it is.
(struct Canvas
  ([film-width : Fixnum] [film-height : Fixnum]
   [left : Fixnum] [top : Fixnum] [width : Fixnum] [height : Fixnum]
   [samples : Fixnum] [offsets : FxVector] [subpixels : Fixnum]
   [keys : FlVector] [ids : FxVector] [scratch : FlVector] [slack : Flonum]))

(: make-Canvas (-> Fixnum Fixnum Fixnum Fixnum Fixnum Fixnum FxVector Fixnum Canvas))
(define (make-Canvas film-width film-height left top width height offsets subpixels)
  (define samples (fxquotient (fxvector-length offsets) 2))
  (define count (fx* samples (fx* width height)))
  (Canvas film-width film-height left top width height samples offsets subpixels
          (make-flvector count -inf.0) (make-fxvector count -1) (make-flvector 256) 0.0))

;; Canvas-forget-surfaces! : leaves only how near they were.
(: Canvas-forget-surfaces! (-> Canvas Void))
(define (Canvas-forget-surfaces! canvas)
  (define ids (Canvas-ids canvas))
  (let each ([k : Fixnum 0])
    (when (fx< k (fxvector-length ids))
      (fxvector-set! ids k -1)
      (each (fx+ k 1)))))

;; Puts a surface at a sample where nothing nearer is; what came first stays where two are as near.
(define-syntax-rule (put-if-nearer! keys ids at key id)
  (when (fl> key (flvector-ref keys at))
    (flvector-set! keys at key)
    (fxvector-set! ids at id)))

;; A corner is four numbers (a, b, w, h): it is seen at a/w to the right and b/w up, where the film
;; reaches from -1 to 1, and h/w is its key. Polygons are clipped as far out as twice the film, which
;; keeps whole numbers small, and where w falls below `near` or the key is above `nearest`.
(define-syntax-rule (GUARD) 2.0)

;; Which clip planes a corner is beyond: those of the film in the lowest four bits, those that have to
;; be clipped in the next.
(define-syntax-rule (outcode a b w h near nearest)
  (fxior
   (fxior (fxior (if (fl< a (fl* -1.0 w)) 1 0) (if (fl> a w) 2 0))
          (fxior (if (fl< b (fl* -1.0 w)) 4 0) (if (fl> b w) 8 0)))
   (if (or (fl< w near) (fl> h (fl* nearest w))
           (fl> (flabs a) (fl* (GUARD) w)) (fl> (flabs b) (fl* (GUARD) w)))
       16 0)))

;; draw-mesh! : draws triangles whose corners are vertices, four numbers each, under the ids from
;; first-id on. faces: 0 for all, 1 for those whose corners turn counter-clockwise in the picture,
;; 2 for the others. edges?: draws the edges instead, as lines a pixel wide.
(: draw-mesh! (-> Canvas FlVector FxVector Fixnum Fixnum Boolean Flonum Flonum Void))
(define (draw-mesh! canvas corners triangles first-id faces edges? near nearest)
  (define vertex-count (fxquotient (flvector-length corners) 4))
  ;; of every vertex: place on the grid and outcode; the key is kept beside them
  (define places (make-fxvector (fx* 3 vertex-count) 0))
  (define keys (make-flvector vertex-count 0.0))
  (let each ([k : Fixnum 0])
    (when (fx< k vertex-count)
      (let* ([at (fx* 4 k)]
             [a (flvector-ref corners at)] [b (flvector-ref corners (fx+ at 1))]
             [w (flvector-ref corners (fx+ at 2))] [h (flvector-ref corners (fx+ at 3))]
             [code (outcode a b w h near nearest)])
        (fxvector-set! places (fx+ 2 (fx* 3 k)) code)
        (when (fx= 0 (fxand code 16))
          (fxvector-set! places (fx* 3 k) (grid-x canvas (fl/ a w)))
          (fxvector-set! places (fx+ 1 (fx* 3 k)) (grid-y canvas (fl/ b w)))
          (flvector-set! keys k (fl/ h w))))
      (each (fx+ k 1))))
  (define triangle-count (fxquotient (fxvector-length triangles) 3))
  (let each ([k : Fixnum 0])
    (when (fx< k triangle-count)
      (let* ([at (fx* 3 k)]
             [p (fxvector-ref triangles at)]
             [q (fxvector-ref triangles (fx+ at 1))]
             [s (fxvector-ref triangles (fx+ at 2))]
             [p-code (fxvector-ref places (fx+ 2 (fx* 3 p)))]
             [q-code (fxvector-ref places (fx+ 2 (fx* 3 q)))]
             [s-code (fxvector-ref places (fx+ 2 (fx* 3 s)))])
        (when (fx= 0 (fxand 15 (fxand p-code (fxand q-code s-code))))
          (cond
            [edges?
             (draw-edge! canvas corners p q (fx+ first-id k) near nearest)
             (draw-edge! canvas corners q s (fx+ first-id k) near nearest)
             (draw-edge! canvas corners s p (fx+ first-id k) near nearest)]
            [(fx= 0 (fxand 16 (fxior p-code (fxior q-code s-code))))
             (scan-triangle! canvas
                             (fxvector-ref places (fx* 3 p)) (fxvector-ref places (fx+ 1 (fx* 3 p)))
                             (fxvector-ref places (fx* 3 q)) (fxvector-ref places (fx+ 1 (fx* 3 q)))
                             (fxvector-ref places (fx* 3 s)) (fxvector-ref places (fx+ 1 (fx* 3 s)))
                             keys p q s (fx+ first-id k) faces)]
            [else
             (let ([scratch (Canvas-scratch canvas)])
               (copy-corner! corners p scratch 0)
               (copy-corner! corners q scratch 1)
               (copy-corner! corners s scratch 2)
               (clip-and-scan! canvas 3 (fx+ first-id k) faces near nearest))])))
      (each (fx+ k 1)))))

;; draw-polygon! : draws one convex polygon; h may be 0, for corners infinitely far away.
(: draw-polygon! (-> Canvas FlVector Fixnum Fixnum Flonum Flonum Void))
(define (draw-polygon! canvas corners id faces near nearest)
  (define count (fxquotient (flvector-length corners) 4))
  (let each ([k : Fixnum 0])
    (when (fx< k count)
      (copy-corner! corners k (Canvas-scratch canvas) k)
      (each (fx+ k 1))))
  (clip-and-scan! canvas count id faces near nearest))

;; From device coordinates to whole subpixels from the canvas's corner, a half rounded up.
(: grid-x (-> Canvas Flonum Fixnum))
(define (grid-x canvas x)
  (fl->fx (flfloor (fl+ 0.5 (fl* (fx->fl (Canvas-subpixels canvas))
                                 (fl- (fl* (fl* 0.5 (fx->fl (Canvas-film-width canvas)))
                                           (fl+ 1.0 x))
                                      (fx->fl (Canvas-left canvas))))))))
(: grid-y (-> Canvas Flonum Fixnum))
(define (grid-y canvas y)
  (fl->fx (flfloor (fl+ 0.5 (fl* (fx->fl (Canvas-subpixels canvas))
                                 (fl- (fl* (fl* 0.5 (fx->fl (Canvas-film-height canvas)))
                                           (fl- 1.0 y))
                                      (fx->fl (Canvas-top canvas))))))))

(define-syntax-rule (copy-corner! from p to q)
  (let copy ([k : Fixnum 0])
    (when (fx< k 4)
      (flvector-set! to (fx+ k (fx* 4 q)) (flvector-ref from (fx+ k (fx* 4 p))))
      (copy (fx+ k 1)))))

;; --- clipping ---

;; How far a corner is inside the clip plane of that number; linear in its four coordinates.
(define-syntax-rule (inside plane a b w h near nearest)
  (cond
    [(fx= plane 0) (fl- w near)]
    [(fx= plane 1) (fl- (fl* nearest w) h)]
    [(fx= plane 2) (fl+ (fl* (GUARD) w) a)]
    [(fx= plane 3) (fl- (fl* (GUARD) w) a)]
    [(fx= plane 4) (fl+ (fl* (GUARD) w) b)]
    [else (fl- (fl* (GUARD) w) b)]))

;; The polygon's `count` corners stand at the scratch's start; clipped by one plane after the other
;; (Sutherland and Hodgman, "Reentrant Polygon Clipping", 1974), from one half of the scratch to the
;; other and back. What is left is drawn as a fan.
(define-syntax-rule (HALF) 16)
(: clip-and-scan! (-> Canvas Fixnum Fixnum Fixnum Flonum Flonum Void))
(define (clip-and-scan! canvas count id faces near nearest)
  (define scratch (Canvas-scratch canvas))
  (let clip ([plane : Fixnum 0] [from : Fixnum 0] [count : Fixnum count])
    (cond
      [(fx< count 3) (void)]
      [(fx< plane 6)
       (define to (fx- (HALF) from))
       (clip (fx+ plane 1) to (clip-by-plane! scratch plane from to count near nearest))]
      [else (scan-fan! canvas from count id faces)])))

;; How many corners are left.
(: clip-by-plane! (-> FlVector Fixnum Fixnum Fixnum Fixnum Flonum Flonum Fixnum))
(define (clip-by-plane! scratch plane from to count near nearest)
  (define-syntax-rule (distance k)
    (let ([at (fx* 4 (fx+ from k))])
      (inside plane (flvector-ref scratch at) (flvector-ref scratch (fx+ at 1))
              (flvector-ref scratch (fx+ at 2)) (flvector-ref scratch (fx+ at 3)) near nearest)))
  (let each ([k : Fixnum 0] [kept : Fixnum 0])
    (cond
      [(fx= k count) kept]
      [else
       (define next (if (fx= (fx+ k 1) count) 0 (fx+ k 1)))
       (define in? (fl>= (distance k) 0.0))
       (define next-in? (fl>= (distance next) 0.0))
       (define kept-here
         (cond
           [in? (copy-corner! scratch (fx+ from k) scratch (fx+ to kept)) (fx+ kept 1)]
           [else kept]))
       (cond
         [(eq? in? next-in?) (each (fx+ k 1) kept-here)]
         [else
          ;; from the corner inside to the one outside, whichever comes first: two triangles cut
          ;; their common edge at the same place to the bit
          (define inner (if in? k next))
          (define outer (if in? next k))
          (let* ([d (distance inner)] [part (fl/ d (fl- d (distance outer)))])
            (let blend ([c : Fixnum 0])
              (when (fx< c 4)
                (let ([p (flvector-ref scratch (fx+ c (fx* 4 (fx+ from inner))))]
                      [q (flvector-ref scratch (fx+ c (fx* 4 (fx+ from outer))))])
                  (flvector-set! scratch (fx+ c (fx* 4 (fx+ to kept-here)))
                                 (fl+ p (fl* part (fl- q p)))))
                (blend (fx+ c 1)))))
          (each (fx+ k 1) (fx+ kept-here 1))])])))

;; Corners on the grid; x and y in a small fxvector, keys beside them.
(: scan-fan! (-> Canvas Fixnum Fixnum Fixnum Fixnum Void))
(define (scan-fan! canvas from count id faces)
  (define scratch (Canvas-scratch canvas))
  (define places (make-fxvector 32 0))
  (define keys (make-flvector 16 0.0))
  (let each ([k : Fixnum 0])
    (when (fx< k count)
      (let* ([at (fx* 4 (fx+ from k))]
             [w (flvector-ref scratch (fx+ at 2))])
        (fxvector-set! places (fx* 2 k) (grid-x canvas (fl/ (flvector-ref scratch at) w)))
        (fxvector-set! places (fx+ 1 (fx* 2 k))
                       (grid-y canvas (fl/ (flvector-ref scratch (fx+ at 1)) w)))
        (flvector-set! keys k (fl/ (flvector-ref scratch (fx+ at 3)) w)))
      (each (fx+ k 1))))
  (let each ([k : Fixnum 2])
    (when (fx< k count)
      (scan-triangle! canvas
                      (fxvector-ref places 0) (fxvector-ref places 1)
                      (fxvector-ref places (fx- (fx* 2 k) 2)) (fxvector-ref places (fx- (fx* 2 k) 1))
                      (fxvector-ref places (fx* 2 k)) (fxvector-ref places (fx+ 1 (fx* 2 k)))
                      keys 0 (fx- k 1) k id faces)
      (each (fx+ k 1)))))

;; --- edges as lines ---

;; A line a pixel wide, as a quadrilateral in the picture. The two ends are clipped like a polygon of
;; no width.
(: draw-edge! (-> Canvas FlVector Fixnum Fixnum Fixnum Flonum Flonum Void))
(define (draw-edge! canvas corners p q id near nearest)
  (define scratch (Canvas-scratch canvas))
  (copy-corner! corners p scratch 0)
  (copy-corner! corners q scratch 1)
  (copy-corner! corners q scratch 2)
  (let clip ([plane : Fixnum 0] [from : Fixnum 0] [count : Fixnum 3])
    (cond
      [(fx< count 3) (void)]
      [(fx< plane 6)
       (define to (fx- (HALF) from))
       (clip (fx+ plane 1) to (clip-by-plane! scratch plane from to count near nearest))]
      [else (scan-line! canvas from count id)])))

;; The line between the two corners that are farthest apart.
(: scan-line! (-> Canvas Fixnum Fixnum Fixnum Void))
(define (scan-line! canvas from count id)
  (define scratch (Canvas-scratch canvas))
  (define-syntax-rule (corner-x k)
    (grid-x canvas (fl/ (flvector-ref scratch (fx* 4 (fx+ from k)))
                        (flvector-ref scratch (fx+ 2 (fx* 4 (fx+ from k)))))))
  (define-syntax-rule (corner-y k)
    (grid-y canvas (fl/ (flvector-ref scratch (fx+ 1 (fx* 4 (fx+ from k))))
                        (flvector-ref scratch (fx+ 2 (fx* 4 (fx+ from k)))))))
  (define-syntax-rule (corner-key k)
    (fl/ (flvector-ref scratch (fx+ 3 (fx* 4 (fx+ from k))))
         (flvector-ref scratch (fx+ 2 (fx* 4 (fx+ from k))))))
  (define far
    (let find : Fixnum ([k : Fixnum 1] [best : Fixnum 0] [far : Fixnum 0])
      (cond
        [(fx= k count) far]
        [else
         (define dx (fx- (corner-x k) (corner-x 0)))
         (define dy (fx- (corner-y k) (corner-y 0)))
         (define distance (fx+ (if (fx< dx 0) (fx- 0 dx) dx) (if (fx< dy 0) (fx- 0 dy) dy)))
         (if (fx> distance best) (find (fx+ k 1) distance k) (find (fx+ k 1) best far))])))
  (define-values (x0 y0 x1 y1) (values (corner-x 0) (corner-y 0) (corner-x far) (corner-y far)))
  (define keys (flvector (corner-key 0) (corner-key far)))
  (let* ([dx (fx->fl (fx- x1 x0))] [dy (fx->fl (fx- y1 y0))]
         [length (flsqrt (fl+ (fl* dx dx) (fl* dy dy)))]
         [half (fl* 0.5 (fx->fl (Canvas-subpixels canvas)))])
    (when (fl> length 0.0)
      (let ([ox (fl->fx (flfloor (fl/ (fl* (fl* -1.0 dy) half) length)))]
            [oy (fl->fx (flfloor (fl/ (fl* dx half) length)))])
        (define-syntax-rule (scan! ax ay bx by cx cy p q s)
          (scan-triangle! canvas ax ay bx by cx cy keys p q s id 0))
        (scan! (fx+ x0 ox) (fx+ y0 oy) (fx+ x1 ox) (fx+ y1 oy) (fx- x1 ox) (fx- y1 oy) 0 1 1)
        (scan! (fx+ x0 ox) (fx+ y0 oy) (fx- x1 ox) (fx- y1 oy) (fx- x0 ox) (fx- y0 oy) 0 1 0)))))

;; --- one triangle ---

(define-syntax-rule (fxmin3 a b c)
  (let* ([m (if (fx< a b) a b)]) (if (fx< m c) m c)))
(define-syntax-rule (fxmax3 a b c)
  (let* ([m (if (fx> a b) a b)]) (if (fx> m c) m c)))
;; Whole quotients rounded down; n may be negative, d a power of two given by its logarithm.
(define-syntax-rule (floor-shift n bits) (fxrshift n bits))

(: bits-of (-> Fixnum Fixnum))
(define (bits-of power)
  (let count ([p : Fixnum power] [bits : Fixnum 0])
    (if (fx> p 1) (count (fxrshift p 1) (fx+ bits 1)) bits)))

;; Corners in subpixels; their keys at places k0, k1 and k2. y grows downwards, so a triangle whose
;; doubled area is positive turns clockwise as one sees it; one that turns the other way is turned.
(: scan-triangle! (-> Canvas Fixnum Fixnum Fixnum Fixnum Fixnum Fixnum
                      FlVector Fixnum Fixnum Fixnum Fixnum Fixnum Void))
(define (scan-triangle! canvas x0 y0 x1 y1 x2 y2 keys k0 k1 k2 id faces)
  (define area (fx- (fx* (fx- x1 x0) (fx- y2 y0)) (fx* (fx- x2 x0) (fx- y1 y0))))
  (cond
    [(fx= area 0) (void)]
    [(fx< area 0)
     (unless (fx= faces 2)
       (scan-clockwise! canvas (fx- 0 area) x0 y0 x2 y2 x1 y1 keys k0 k2 k1 id))]
    [else
     (unless (fx= faces 1)
       (scan-clockwise! canvas area x0 y0 x1 y1 x2 y2 keys k0 k1 k2 id))]))

(: scan-clockwise! (-> Canvas Fixnum Fixnum Fixnum Fixnum Fixnum Fixnum Fixnum
                       FlVector Fixnum Fixnum Fixnum Fixnum Void))
(define (scan-clockwise! canvas area x0 y0 x1 y1 x2 y2 keys k0 k1 k2 id)
  (define width (Canvas-width canvas))
  (define height (Canvas-height canvas))
  (define samples (Canvas-samples canvas))
  (define offsets (Canvas-offsets canvas))
  (define side (Canvas-subpixels canvas))
  (define bits (bits-of side))
  (define canvas-keys (Canvas-keys canvas))
  (define canvas-ids (Canvas-ids canvas))
  (define-values (dx01 dy01) (values (fx- x1 x0) (fx- y1 y0)))
  (define-values (dx12 dy12) (values (fx- x2 x1) (fx- y2 y1)))
  (define-values (dx20 dy20) (values (fx- x0 x2) (fx- y0 y2)))
  (define left (fxmin3 x0 x1 x2))
  (define right (fxmax3 x0 x1 x2))
  (define top (fxmin3 y0 y1 y2))
  (define bottom (fxmax3 y0 y1 y2))
  (define last-index (fx- samples 1))
  (define slack (Canvas-slack canvas))
  (let* ([q0 (flvector-ref keys k0)]
         [q1 (flvector-ref keys k1)]
         [q2 (flvector-ref keys k2)]
         [lowest (flmin q0 (flmin q1 q2))]
         [low (if (fl> slack 0.0) (fl- lowest (fl* 1e-9 (flabs lowest))) lowest)]
         [high (flmax q0 (flmax q1 q2))]
         [inverse (fl/ 1.0 (fx->fl area))]
         ;; the key's growth for a subpixel to the right and one down
         [slope-x (fl* inverse (fl- (fl* (fl- q1 q0) (fx->fl (fx- y2 y0)))
                                    (fl* (fl- q2 q0) (fx->fl dy01))))]
         [slope-y (fl* inverse (fl- (fl* (fl- q2 q0) (fx->fl dx01))
                                    (fl* (fl- q1 q0) (fx->fl (fx- x2 x0)))))]
         [step (fl* (fx->fl side) slope-x)]
         [start-key (if (fl> slack 0.0)
                        (fl- q0 (fl+ (fl* 1e-9 (flabs q0))
                                     (fl* (fl* slack (fx->fl side))
                                          (fl+ (flabs slope-x) (flabs slope-y)))))
                        q0)])
    (define-syntax-rule (edge dx dy x y px py) (fx- (fx* dx (fx- py y)) (fx* dy (fx- px x))))
    ;; a sample on an edge is inside where the edge is a left one, or a level one at the top
    (define-syntax-rule (owned dx dy)
      (if (or (fx< dy 0) (and (fx= dy 0) (fx> dx 0))) 0 -1))
    ;; steps to the right until an edge function is not negative; past the film where it never is
    (define-syntax-rule (steps-to-enter e step)
      (if (fx>= e 0)
          0
          (if (fx> step 0) (fxquotient (fx+ (fx- 0 e) (fx- step 1)) step) width)))
    (let each-sample ([sample : Fixnum 0])
      (when (fx<= sample last-index)
        (let* ([sx (fxvector-ref offsets (fx* 2 sample))]
               [sy (fxvector-ref offsets (fx+ 1 (fx* 2 sample)))]
               [first-x (let ([c (floor-shift (fx+ (fx- left sx) (fx- side 1)) bits)])
                          (if (fx< c 0) 0 c))]
               [last-x (let ([c (floor-shift (fx- right sx) bits)])
                         (if (fx< c width) c (fx- width 1)))]
               [first-y (let ([c (floor-shift (fx+ (fx- top sy) (fx- side 1)) bits)])
                          (if (fx< c 0) 0 c))]
               [last-y (let ([c (floor-shift (fx- bottom sy) bits)])
                         (if (fx< c height) c (fx- height 1)))]
               [start-x (fx+ sx (fx* side first-x))])
          (when (fx<= first-x last-x)
            (let rows ([y : Fixnum first-y])
              (when (fx<= y last-y)
                (let* ([py (fx+ sy (fx* side y))]
                       [row-key (fl+ start-key (fl+ (fl* slope-x (fx->fl (fx- start-x x0)))
                                             (fl* slope-y (fx->fl (fx- py y0)))))])
                  (let* ([s0 (fx* (fx- 0 dy01) side)]
                         [s1 (fx* (fx- 0 dy12) side)]
                         [s2 (fx* (fx- 0 dy20) side)]
                         [a0 (fx+ (owned dx01 dy01) (edge dx01 dy01 x0 y0 start-x py))]
                         [a1 (fx+ (owned dx12 dy12) (edge dx12 dy12 x1 y1 start-x py))]
                         [a2 (fx+ (owned dx20 dy20) (edge dx20 dy20 x2 y2 start-x py))]
                         [skip (fxmax3 (steps-to-enter a0 s0) (steps-to-enter a1 s1)
                                       (steps-to-enter a2 s2))])
                    (let columns ([x : Fixnum (fx+ first-x skip)]
                                  [e0 : Fixnum (fx+ a0 (fx* skip s0))]
                                  [e1 : Fixnum (fx+ a1 (fx* skip s1))]
                                  [e2 : Fixnum (fx+ a2 (fx* skip s2))])
                      (when (and (fx<= x last-x) (fx>= (fxior e0 (fxior e1 e2)) 0))
                        (let* ([at (fx+ sample (fx* samples (fx+ x (fx* y width))))]
                               [plain (fl+ row-key (fl* step (fx->fl (fx- x first-x))))]
                               [key (if (fl< plain low) low (if (fl> plain high) high plain))])
                          (put-if-nearer! canvas-keys canvas-ids at key id))
                        (columns (fx+ x 1) (fx+ e0 s0) (fx+ e1 s1) (fx+ e2 s2))))))
                (rows (fx+ y 1)))))
          (each-sample (fx+ sample 1)))))))
