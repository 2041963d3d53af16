#lang racket/base
;; Rasterization and ray tracing show the same: silhouettes, depth and normals differ at no pixel that
;; is farther than half a pixel from an edge.

(module+ test
  (require racket/flonum racket/list rackunit "../../main.rkt" "scenes.rkt")

  (define width 160)
  (define height 90)

  ;; What rays find at the middles of fifths of pixels: so every pixel's middle, and what is up to two
  ;; fifths of a pixel beside it.
  (define FINE 5)
  (define (trace world camera integrator)
    (render world camera #:width (* FINE width) #:height (* FINE height) #:samples 1
            #:integrator integrator))
  (define (value image x y channel)
    (flvector-ref (Image-pixels image) (+ channel (* 3 (+ x (* y (Image-width image)))))))
  (define (normal image x y)
    (Float3 (- (* 2 (value image x y 0)) 1) (- (* 2 (value image x y 1)) 1)
            (- (* 2 (value image x y 2)) 1)))

  ;; Two surfaces seen by two rays are one as far as a picture shows: relative depth and normal.
  (define (same? depth normal other-depth other-normal depth-tolerance normal-tolerance)
    (cond
      [(zero? depth) (zero? other-depth)]
      [else (and (not (zero? other-depth))
                 (<= (abs (- depth other-depth)) (* depth-tolerance depth))
                 (<= (Float3-length (Float3-subtract normal other-normal)) normal-tolerance))]))

  ;; Pixels that differ; those of them that are farther than half a pixel from an edge; all near an
  ;; edge.
  (define (compare world camera)
    (define depths (trace world camera 'depth))
    (define normals (trace world camera 'normals))
    (define raster-depths (preview world camera #:width width #:height height #:samples 1
                                   #:shading 'depth))
    (define raster-normals (preview world camera #:width width #:height height #:samples 1
                                    #:shading 'normals))
    (for*/fold ([differing 0] [unexplained '()] [near-edges 0])
               ([y height] [x width])
      (define-values (fx fy) (values (+ 2 (* FINE x)) (+ 2 (* FINE y))))
      (define (depth-at dx dy) (value depths (+ fx dx) (+ fy dy) 0))
      (define (normal-at dx dy) (normal normals (+ fx dx) (+ fy dy)))
      (define-values (depth n) (values (depth-at 0 0) (normal-at 0 0)))
      (define edge?
        (for*/or ([dx '(-2 -1 0 1 2)] [dy '(-2 -1 0 1 2)])
          (not (same? depth n (depth-at dx dy) (normal-at dx dy) 0.01 0.08))))
      (define agrees?
        (same? depth n (value raster-depths x y 0) (normal raster-normals x y) 0.002 0.02))
      (values (if agrees? differing (+ differing 1))
              (if (or agrees? edge?) unexplained
                  (cons (list x y depth (value raster-depths x y 0)) unexplained))
              (if edge? (+ near-edges 1) near-edges))))

  (for ([scene raster-scenes])
    (test-case (format "~a: all differences are at edges" (car scene))
      (define-values (differing unexplained near-edges) (compare (cadr scene) (caddr scene)))
      (when (getenv "RASTER_COUNTS")
        (printf "~a: ~a of ~a pixels differ, ~a are near edges\n" (car scene) differing
                (* width height) near-edges))
      (check-equal? (if (> (length unexplained) 5) (take unexplained 5) unexplained) '())
      (check-true (> near-edges 100))
      (check-true (< differing (* 0.12 near-edges))
                  (format "~a of ~a differ" differing near-edges))))

  (test-case "cameras that bend lines: the same rays, so the same depths, 1e-12"
    (for ([camera (list (Camera-panoramic (Float3 0 1.5 3) (Float3 0 1 0))
                        (Camera-fisheye (Float3 0 1.5 3) (Float3 0 1 0) #:field-of-view-degrees 220))])
      (define world (cadr (car raster-scenes)))
      (define traced (render world camera #:width 64 #:height 32 #:samples 1 #:integrator 'depth))
      (define drawn (preview world camera #:width 64 #:height 32 #:samples 1 #:shading 'depth))
      (for ([a (in-flvector (Image-pixels traced))] [b (in-flvector (Image-pixels drawn))])
        (check-= a b (* 1e-12 a)))))

  (test-case "texture coordinates: those of the shapes themselves at the same place of the picture"
    (define camera (Camera-look-at (Float3 1 2.5 9) (Float3 0 1.5 0) #:zoom 1.7))
    (for ([shape all-shapes])
      (define drawn (preview (World (list shape)) camera #:width 160 #:height 90 #:samples 1
                             #:shading 'texture-coordinates))
      (define depths (preview (World (list shape)) camera #:width 160 #:height 90 #:samples 1
                              #:shading 'depth))
      (define differences
        (for*/list ([y (in-range 5 90 5)] [x (in-range 4 156 4)]
                    #:unless (zero? (value depths x y 0)))
          (define ray (Camera-unproject camera (Float3 (+ x 0.5) (+ y 0.5) 1.0)
                                        #:width 160 #:height 90))
          ;; rays are cast for a fisheye; one so narrow that it sees a point
          (define narrow (Camera-fisheye (Float3 1 2.5 9) ray #:field-of-view-degrees 1e-4))
          (define exact (preview (World (list shape)) narrow #:width 1 #:height 1 #:samples 1
                                 #:shading 'texture-coordinates))
          (define (apart a b) (let ([d (abs (- a b))]) (min d (abs (- 1 d)))))
          (max (apart (value exact 0 0 0) (value drawn x y 0))
               (apart (value exact 0 0 1) (value drawn x y 1)))))
      (define sorted (sort differences <))
      (check-true (pair? sorted))
      ;; but for pixels on edges and next to poles
      (check-true (< (list-ref sorted (quotient (* 8 (length sorted)) 10)) 0.02)
                  (format "~a: ~a" shape sorted)))))
