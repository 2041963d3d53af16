#lang racket/base
;; The Utah teapot drawn by rasterization, shaded in the four classical ways side by side: one colour a
;; triangle, colours of corners interpolated (Gouraud 1971), normals of corners interpolated (Phong
;; 1975), and those in a few steps with an outline.
;; raco raytrace teapot-shading -o teapot-shading.png
(require raytrace)

(provide world camera settings)

;; Few enough triangles to tell the shadings apart.
(define pot (teapot #:tolerance 0.05 #:material (Phong (Float3 0.75 0.3 0.16) 0.5 40)))

(define world
  (World (list (Instance pot (Transform-rotate (Float3 0 1 0) #:degrees -35)))
         (list (DistantLight (Float3 -2 3 4) (Float3 0.85 0.82 0.78))
               (PointLight (Float3 6 4 3) (Float3 9 11 14)))
         (Float3 0.82 0.86 0.9)
         #:ambient-color (Float3 0.16 0.17 0.2)))

(define camera
  (Camera-look-at (Float3 0 5.5 11) (Float3 0.2 1.45 0) #:vertical-field-of-view-degrees 34))

(define settings
  (hash 'size '(1600 400) 'integrator 'raster 'shading '(flat gouraud phong toon) 'samples 8))
