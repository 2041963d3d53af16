#lang racket/base
;; The teapot's data, and bezier-patches->mesh: distance to the surface, normals, watertightness.

(module+ test
  (require racket/fixnum racket/flonum racket/list rackunit
           "../../private/read/teapot-patches.rkt" "../../private/shape/bezier.rkt")

  ;; --- Reference: vectors as lists, patches as lists of 16 points, de Casteljau's construction ---

  (define (add p q) (map + p q))
  (define (subtract p q) (map - p q))
  (define (scale s p) (map (lambda (c) (* s c)) p))
  (define (dot p q) (apply + (map * p q)))
  (define (norm p) (sqrt (dot p p)))
  (define (distance p q) (norm (subtract p q)))
  (define (cross p q)
    (define-values (px py pz qx qy qz) (apply values (append p q)))
    (list (- (* py qz) (* pz qy)) (- (* pz qx) (* px qz)) (- (* px qy) (* py qx))))
  (define (lerp t p q) (add (scale (- 1.0 t) p) (scale t q)))

  (define (curve-point points t)
    (if (null? (cdr points))
        (car points)
        (curve-point (for/list ([p points] [q (cdr points)]) (lerp t p q)) t)))
  (define (rows patch) (for/list ([row 4]) (take (drop patch (* 4 row)) 4)))
  (define (patch-point patch u v)
    (curve-point (map (lambda (row) (curve-point row u)) (rows patch)) v))

  (define (tuples vectors size)
    (for/list ([start (in-range 0 (flvector-length vectors) size)])
      (for/list ([k size]) (flvector-ref vectors (+ start k)))))
  (define control-points (tuples teapot-points 3))
  (define patches
    (let ([points (list->vector control-points)])
      (for/list ([start (in-range 0 (fxvector-length teapot-patches) 16)])
        (for/list ([k 16]) (vector-ref points (fxvector-ref teapot-patches (+ start k)))))))
  (define (part from count) (take (drop patches from) count))
  (define-values (rim body handle spout lid bottom)
    (values (part 0 4) (part 4 8) (part 12 4) (part 16 4) (part 20 8) (part 28 4)))

  (struct mesh (positions normals uvs triangles)) ; vectors of lists, list of lists
  (define (vectors->mesh positions normals uvs triangles)
    (mesh (list->vector (tuples positions 3)) (list->vector (tuples normals 3))
          (list->vector (tuples uvs 2))
          (for/list ([start (in-range 0 (fxvector-length triangles) 3)])
            (for/list ([k 3]) (fxvector-ref triangles (+ start k))))))
  (define (teapot tolerance #:uv? [uv? #t])
    (call-with-values (lambda () (teapot-mesh-vectors #:tolerance tolerance #:uv? uv?))
                      vectors->mesh))
  (define (patches->mesh patches tolerance #:uv? [uv? #t])
    (define coordinates (map real->double-flonum (apply append (apply append patches))))
    (call-with-values
     (lambda ()
       (bezier-patches->mesh (apply flvector coordinates)
                             (apply fxvector (range (* 16 (length patches))))
                             #:tolerance tolerance #:uv? uv?))
     vectors->mesh))
  (define (position m i) (vector-ref (mesh-positions m) i))
  (define (corners m triangle) (map (lambda (i) (position m i)) triangle))
  (define (area-vector m triangle)
    (define-values (a b c) (apply values (corners m triangle)))
    (cross (subtract b a) (subtract c a)))

  ;; --- Data ---

  (test-case "the data set has 306 points, 32 patches, and only its four known unused points"
    (check-equal? (length control-points) 306)
    (check-equal? (length patches) 32)
    (define used (for/hash ([i (in-fxvector teapot-patches)]) (values i #t)))
    (check-equal? (for/list ([i 306] #:unless (hash-ref used i #f)) i) '(204 205 215 222)))

  (test-case "the data's bounding box"
    (define (extent axis) (let ([c (map (lambda (p) (list-ref p axis)) control-points)])
                            (list (apply min c) (apply max c))))
    (check-equal? (map extent '(0 1 2)) '((-3.0 3.525) (-2.0 2.0) (0.0 3.15))))

  (define (without-negative-zero p) (map (lambda (c) (+ c 0.0)) p))
  (define (same-patches? some others)
    (define (keys patches)
      (for/hash ([patch patches]) (values (map without-negative-zero patch) #t)))
    (equal? (keys some) (keys others)))

  (test-case "rim, body, lid and bottom are unchanged by a quarter turn, exactly"
    (define (quarter-turn p) (list (cadr p) (- (car p)) (caddr p)))
    (for ([part (list rim body lid bottom)])
      (check-true (same-patches? part (map (lambda (patch) (map quarter-turn patch)) part)))))

  (test-case "every part is its own mirror image in y, exactly"
    (define (mirrored patch)
      (append* (for/list ([row (rows patch)])
                 (reverse (map (lambda (p) (list (car p) (- (cadr p)) (caddr p))) row)))))
    (for ([part (list rim body handle spout lid bottom)])
      (check-true (same-patches? part (map mirrored part)))))

  (test-case "rings are r (1, f) with f = 0.56, but 0.5625 on the widest ring of the knob"
    (define ratios
      (for*/list ([patch (append rim body lid bottom)] [row (rows patch)]
                  #:unless (apply equal? (take row 2)))
        (define-values (a b) (values (map abs (take (car row) 2)) (map abs (take (cadr row) 2))))
        (/ (apply min b) (apply max a))))
    (define-values (knob others) (partition (lambda (f) (= f 0.5625)) ratios))
    (check-equal? (length knob) 4)
    (for ([f others]) (check-= f 0.56 1e-15)))

  ;; --- Distance to the surface ---

  (define barycentrics
    (for*/list ([a 4] [b (- 4 a)]) (list (/ a 3.0) (/ b 3.0) (/ (- 3 a b) 3.0))))
  (define (blend weights points) (apply add* (map scale weights points)))
  (define (add* . points) (foldl add (car points) (cdr points)))

  ;; The greatest distance from a point of the mesh to the surface at the same u, v: it bounds the
  ;; distance from the mesh to the surface and, the triangles covering [0, 1]², the other way.
  (define (parametric-distance patch m)
    (for*/fold ([worst 0.0]) ([triangle (mesh-triangles m)] [weights barycentrics])
      (define-values (u v)
        (apply values (blend weights (map (lambda (i) (vector-ref (mesh-uvs m) i)) triangle))))
      (max worst (distance (patch-point patch u v) (blend weights (corners m triangle))))))

  (test-case "each patch's mesh is within the tolerance of the patch, and not over-divided 20 times"
    (for ([tolerance '(0.3 0.05 0.01)])
      (define errors
        (for/list ([patch patches])
          (parametric-distance patch (patches->mesh (list patch) tolerance))))
      (check-true (<= (apply max errors) (* tolerance (+ 1.0 1e-12))))
      (when (< tolerance 0.1) ; counts of at least 2 do more than 0.3 asks for
        (check-true (>= (apply max errors) (/ tolerance 2.0)))
        (check-true (>= (apply min errors) (/ tolerance 20.0))))))

  ;; Ericson, "Real-Time Collision Detection", 2005, 5.1.5, by projection onto plane and edges.
  (define (point-triangle-distance p a b c)
    (define n (cross (subtract b a) (subtract c a)))
    (define (inside-edge? a b) (>= (dot (cross (subtract b a) (subtract p a)) n) 0.0))
    (define (segment-distance a b)
      (define direction (subtract b a))
      (define t (/ (dot (subtract p a) direction) (dot direction direction)))
      (distance p (lerp (max 0.0 (min 1.0 t)) a b)))
    (if (and (inside-edge? a b) (inside-edge? b c) (inside-edge? c a))
        (/ (abs (dot n (subtract p a))) (norm n))
        (min (segment-distance a b) (segment-distance b c) (segment-distance c a))))

  (define (distance-to-mesh p m longest)
    (for/fold ([best +inf.0]) ([triangle (mesh-triangles m)])
      (if (> (distance p (position m (car triangle))) (+ best longest))
          best
          (min best (apply point-triangle-distance p (corners m triangle))))))

  (test-case "points of the true surface are within the tolerance of the teapot's mesh (640, seed 4)"
    (define generator (make-pseudo-random-generator))
    (parameterize ([current-pseudo-random-generator generator])
      (random-seed 4)
      (for ([tolerance '(0.05 0.01)] [samples '(16 4)])
        (define m (teapot tolerance))
        (define longest
          (for*/fold ([l 0.0]) ([triangle (mesh-triangles m)])
            (define-values (a b c) (apply values (corners m triangle)))
            (max l (distance a b) (distance b c) (distance c a))))
        (define errors
          (for*/list ([patch patches] [_ samples])
            (define p (patch-point patch (random) (random)))
            (distance-to-mesh (list (car p) (caddr p) (- (cadr p))) m longest)))
        (check-true (<= (apply max errors) tolerance))
        (check-true (>= (apply max errors) (/ tolerance 20.0))))))

  (test-case "triangles grow as 1/tolerance: a half gives twice, a quarter four times, within 15%"
    (define (triangle-count tolerance) (length (mesh-triangles (teapot tolerance))))
    (define counts (map triangle-count '(0.02 0.01 0.005)))
    (check-= (/ (cadr counts) (car counts)) 2.0 0.3)
    (check-= (/ (caddr counts) (car counts)) 4.0 0.6))

  ;; --- Normals ---

  (test-case "normals are unit vectors to 1e-12; positions and uvs are numbers in range"
    (for ([tolerance '(0.05 0.01)])
      (define m (teapot tolerance))
      (for ([n (mesh-normals m)]) (check-= (norm n) 1.0 1e-12))
      (for ([p (mesh-positions m)])
        (check-true (and (<= -3.0 (car p) 3.525) (<= 0.0 (cadr p) 3.15) (<= -2.0 (caddr p) 2.0))))
      (for ([uv (mesh-uvs m)]) (check-true (andmap (lambda (c) (<= 0.0 c 1.0)) uv)))))

  (test-case "triangles face as their vertices' normals, but 4 at the spout's lip, narrower than 0.05"
    (define (disagreeing m)
      (for/list ([triangle (mesh-triangles m)]
                 #:unless (for/and ([i triangle])
                            (> (dot (area-vector m triangle) (vector-ref (mesh-normals m) i)) 0.0)))
        (corners m triangle)))
    (define at-lip (disagreeing (teapot 0.05)))
    (check-equal? (length at-lip) 4)
    (for* ([triangle at-lip] [p triangle]) (check-true (and (> (car p) 3.3) (> (cadr p) 2.4))))
    (check-equal? (length (disagreeing (teapot 0.01))) 0)
    (check-equal? (length (disagreeing (teapot 0.004))) 0))

  (test-case "vertex normals are perpendicular to the surface, to finite differences' 1e-6"
    (for ([patch patches])
      (define m (patches->mesh (list patch) 0.02))
      (for ([uv (mesh-uvs m)] [n (mesh-normals m)])
        (define-values (u v) (apply values uv))
        (when (and (< 0.01 u 0.99) (< 0.01 v 0.99))
          (define h 1e-5)
          (define (along du dv)
            (scale (/ 0.5 h) (subtract (patch-point patch (+ u du) (+ v dv))
                                       (patch-point patch (- u du) (- v dv)))))
          (define-values (pu pv) (values (along h 0.0) (along 0.0 h)))
          (check-= (dot n pu) 0.0 1e-6)
          (check-= (dot n pv) 0.0 1e-6)
          (check-true (> (dot n (cross pu pv)) 0.0))))))

  (test-case "normals point outwards on every part"
    (define (normals-of patch)
      (define m (patches->mesh (list patch) 0.02))
      (for/list ([uv (mesh-uvs m)] [n (mesh-normals m)] [p (mesh-positions m)]) (list uv p n)))
    (for* ([patch body] [vertex (normals-of patch)])
      (define-values (uv p n) (apply values vertex))
      (check-true (> (+ (* (car p) (car n)) (* (cadr p) (cadr n))) 0.0)))
    (for* ([patch bottom] [vertex (normals-of patch)] #:when (< (caddr (cadr vertex)) 0.05))
      (check-true (< (caddr (caddr vertex)) 0.0)))
    (for* ([patch (drop lid 4)] [vertex (normals-of patch)])
      (check-true (>= (caddr (caddr vertex)) -1e-12)))
    ;; A half tube's section at v has its centre between its two ends. The spout's upper patches turn
    ;; into the spout at its lip: their orientation follows from their edges, tested below.
    (for* ([patch (append handle (take spout 2))] [vertex (normals-of patch)])
      (define-values (uv p n) (apply values vertex))
      (define centre (lerp 0.5 (patch-point patch 0.0 (cadr uv)) (patch-point patch 1.0 (cadr uv))))
      (check-true (> (dot n (subtract p centre)) 0.0))))

  (test-case "at the poles of lid and bottom the normal is the axis, exactly"
    (define m (teapot 0.05 #:uv? #f))
    (define (normal-at p)
      (for/list ([q (mesh-positions m)] [n (mesh-normals m)] #:when (equal? p q)) n))
    (check-equal? (map (lambda (n) (map + n '(0.0 0.0 0.0))) (normal-at '(0.0 3.15 0.0)))
                  '((0.0 1.0 0.0)))
    (check-equal? (map (lambda (n) (map + n '(0.0 0.0 0.0))) (normal-at '(0.0 0.0 0.0)))
                  '((0.0 -1.0 0.0))))

  ;; The eight ways to lay out a patch: turned so that its pole is on each edge, and mirrored.
  (define (transposed patch) (append* (apply map list (rows patch))))
  (define (flipped patch) (append* (reverse (rows patch))))
  (define (turned patch) (transposed (flipped patch)))

  (test-case "a collapsed edge has its limit normal on whichever side of the patch it is"
    (define knob (car lid))
    (define turns (list knob (turned knob) (turned (turned knob)) (turned (turned (turned knob)))))
    (for ([patch (append turns (map transposed turns))] [z '(1.0 1.0 1.0 1.0 -1.0 -1.0 -1.0 -1.0)])
      (define m (patches->mesh (list patch) 0.01))
      (define at-pole (for/list ([p (mesh-positions m)] [n (mesh-normals m)]
                                 #:when (equal? p '(0.0 0.0 3.15)))
                        n))
      (check-true (> (length at-pole) 1))
      (for ([n at-pole])
        (check-true (< (distance n (list 0.0 0.0 z)) 1e-15)))
      (for ([triangle (mesh-triangles m)] #:when #t [i triangle])
        (check-true (> (dot (area-vector m triangle) (vector-ref (mesh-normals m) i)) 0.0)))))

  (test-case "where both partial derivatives vanish the normal is the limit to 1e-3"
    ;; The corner's neighbours on both edges are the corner itself; the patch lies in z = 0.
    (define patch
      (for*/list ([row 4] [column 4])
        (define (place k) (if (<= k 1) 0.0 (/ k 3.0)))
        (list (if (= row 0) (place column) (/ column 3.0))
              (if (= column 0) (place row) (/ row 3.0))
              0.0)))
    (for ([n (mesh-normals (patches->mesh (list patch) 0.01))])
      (check-true (< (distance n '(0.0 0.0 1.0)) 1e-3)))
    ;; A sector of a disk in z = 0 with two rows in its pole, where ∂u × ∂v vanishes as v³.
    (define arc '((0 3 0) (2 3 0) (3 2 0) (3 0 0)))
    (define sector (append (make-list 8 '(0 0 0)) arc arc))
    (for ([n (mesh-normals (patches->mesh (list sector) 0.01))])
      (check-true (< (distance n '(0.0 0.0 1.0)) 1e-3))))

  (test-case "patches collapsed to a point or a line give no triangles and no NaN"
    (for ([patch (list (for/list ([_ 16]) '(1.0 2.0 3.0))
                       (for*/list ([row 4] [column 4]) (list (exact->inexact column) 0.0 0.0)))])
      (define m (patches->mesh (list patch) 0.01))
      (check-equal? (mesh-triangles m) '())
      (for ([n (mesh-normals m)]) (check-equal? (norm n) 1.0))))

  ;; --- Watertightness ---

  ;; Directed edges -> how many triangles have them; vertices named by `name`.
  (define (directed-edges m name)
    (for*/fold ([edges (hash)]) ([triangle (mesh-triangles m)]
                                 [ends (let ([t (map name triangle)])
                                         (map cons t (append (cdr t) (list (car t)))))])
      (hash-update edges ends add1 0)))
  (define (boundary-edges edges)
    (for/list ([ends (in-hash-keys edges)] #:unless (hash-ref edges (cons (cdr ends) (car ends)) #f))
      ends))
  ;; The closed loops that edges form, each a list of vertices.
  (define (loops edges)
    (define next (for/hash ([ends edges]) (values (car ends) (cdr ends))))
    (let collect ([left next] [result '()])
      (if (hash-empty? left)
          result
          (let walk ([at (car (hash-keys left))] [left left] [loop '()])
            (if (hash-has-key? left at)
                (walk (hash-ref left at) (hash-remove left at) (cons at loop))
                (collect left (cons loop result)))))))

  ;; The six open edges of the original, y up.
  (define (opening p)
    (define-values (x y z) (apply values p))
    (define radius (sqrt (+ (* x x) (* z z))))
    (define (between? low c high) (<= (- low 1e-12) c (+ high 1e-12)))
    (cond
      [(and (between? 2.4 y 2.4) (between? 1.4 radius 1.41)) 'rim]
      [(and (between? 2.4 y 2.4) (between? 1.3 radius 1.31)) 'lid]
      [(and (between? -1.6 x -1.5) (between? 2.025 y 2.25)) 'handle-top]
      [(and (between? -2.0 x -1.9) (between? 0.6 y 0.9)) 'handle-foot]
      [(and (between? 1.7 x 1.7) (between? 0.6 y 1.425)) 'spout-base]
      [(and (between? 2.8 x 3.2) (between? 2.4 y 2.4)) 'spout-tip]
      [else (list 'elsewhere p)]))

  (test-case "every edge has one triangle on each side, but for the six open edges of the original"
    (for ([tolerance '(1.0 0.05 0.01)])
      (define m (teapot tolerance #:uv? #f))
      (define edges (directed-edges m values))
      (check-equal? (apply max (hash-values edges)) 1)
      (define boundary (boundary-edges edges))
      (define openings
        (for/list ([loop (loops boundary)])
          (define names (remove-duplicates (map (lambda (i) (opening (position m i))) loop)))
          (check-equal? (length names) 1)
          (car names)))
      (check-equal? (sort openings symbol<?)
                    '(handle-foot handle-top lid rim spout-base spout-tip))
      ;; Euler: 1 for pot and for lid, which are disks, 0 for handle and for spout, which are tubes.
      (define edge-count (/ (+ (hash-count edges) (length boundary)) 2))
      (check-equal? (- (+ (vector-length (mesh-positions m)) (length (mesh-triangles m))) edge-count)
                    2)))

  (test-case "with uvs the same triangles lie on bit-equal positions and normals"
    (define-values (with without) (values (teapot 0.02) (teapot 0.02 #:uv? #f)))
    (define (shape m)
      (for/list ([triangle (mesh-triangles m)])
        (for/list ([i triangle]) (cons (position m i) (vector-ref (mesh-normals m) i)))))
    (check-equal? (shape with) (shape without))
    (check-equal? (vector-length (mesh-uvs without)) 0)
    (check-true (> (vector-length (mesh-positions with)) (vector-length (mesh-positions without)))))

  (test-case "patches that share an edge in opposite directions and bend differently leave no crack"
    (define flat (for*/list ([row 4] [column 4]) (list column row 0)))
    ;; Turned half around the middle of the edge x = 3, and lifted away from it.
    (define bent
      (for*/list ([row 4] [column 4])
        (list (- 6 column) (- 3 row) (if (= column 3) 0 (* row row)))))
    (define m (patches->mesh (list flat bent) 0.001 #:uv? #f))
    ;; The patches meet in a crease, so vertices there are two: name them by position.
    (define edges (directed-edges m (lambda (i) (position m i))))
    (check-equal? (apply max (hash-values edges)) 1)
    (check-equal? (for/list ([ends (boundary-edges edges)]
                             #:when (and (= (car (car ends)) 3.0) (= (car (cdr ends)) 3.0)))
                    ends)
                  '()))

  (test-case "a flat square patch has its exact area and normal"
    (define m (patches->mesh
               (list (for*/list ([row 4] [column 4]) (list (/ column 3.0) (/ row 3.0) 5.0)))
               0.01))
    (check-= (for/sum ([triangle (mesh-triangles m)]) (/ (norm (area-vector m triangle)) 2.0))
             1.0 1e-15)
    (for ([n (mesh-normals m)]) (check-true (< (distance n '(0.0 0.0 1.0)) 1e-15))))

  (test-case "the teapot at tolerance 0.01: counts, and the box it stands in"
    (define m (teapot 0.01))
    (define (extent axis) (let ([c (for/list ([p (mesh-positions m)]) (list-ref p axis))])
                            (list (apply min c) (apply max c))))
    (check-equal? (extent 1) '(0.0 3.15))
    (check-equal? (extent 2) '(-2.0 2.0))
    (check-equal? (car (extent 0)) -3.0)
    (check-= (cadr (extent 0)) 3.434 0.01)
    (check-equal? (vector-length (mesh-normals m)) (vector-length (mesh-positions m)))
    (check-equal? (vector-length (mesh-uvs m)) (vector-length (mesh-positions m))))

  ;; --- Bad arguments ---

  (test-case "arguments out of range raise one line that says which and what was expected"
    (define (message points patches tolerance)
      (with-handlers ([exn:fail:user? exn-message])
        (bezier-patches->mesh points patches #:tolerance tolerance)
        #f))
    (define square (apply flvector (for*/list ([row 4] [column 4] [c (list row column 0)])
                                     (->fl c))))
    (define indices (apply fxvector (range 16)))
    (for ([text (list (message square indices 0.0) (message square indices +nan.0)
                      (message (flvector 0.0 1.0) indices 0.1)
                      (message (flvector +inf.0 0.0 0.0) indices 0.1)
                      (message square (fxvector 1 2 3) 0.1)
                      (message square (make-fxvector 16 16) 0.1)
                      (message square (make-fxvector 16 -1) 0.1)
                      (message teapot-points teapot-patches 1e-12)
                      (message teapot-points teapot-patches 1e-300))]
          [pattern '(#rx"tolerance is 0.0" #rx"tolerance is .nan.0" #rx"2 numbers" #rx"finite number"
                     #rx"3 indices" #rx"is 16, expected 0 to 15" #rx"is -1, expected 0 to 15"
                     #rx"needs more than" #rx"needs more than")])
      (check-true (and (string? text) (regexp-match? pattern text)
                       (not (regexp-match? #rx"\n" text)))
                  (format "~s ~s" pattern text)))))
