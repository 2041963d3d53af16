#lang racket/base
;; Lights in groups and instances: sampled as in the world, so that with the same seed the pictures
;; agree pixel by pixel, and so do their variances; what cannot be sampled is still found.

(module+ test
  (require racket/flonum racket/fixnum racket/list racket/math rackunit
           "../../main.rkt" "../statistics.rkt" "light-choices.rkt")

  (define black (Float3 0 0 0))
  (define origin black)
  (define shining (Emitter (Float3 1 2 3)))
  (define both (Emitter (Float3 3 2 1) #:two-sided? #t #:surface (Lambertian (Float3 0.4 0.4 0.4))))

  ;; One of each kind that is sampled, over the floor or beside it.
  (define (quad material) (Quad (Float3 -1 -1 1.5) (Float3 0 2 0) (Float3 2 0 0) material))
  (define (slanted material) (Quad (Float3 -1 -1 1.5) (Float3 0 2 0.5) (Float3 2 0.3 0) material))
  (define (disk material) (Disk (Float3 0.5 0.2 1.2) (Float3 0.3 0.1 -1) 0.7 material))
  (define (triangle material)
    (Triangle (Float3 -1 -1 1) (Float3 0 1 1.4) (Float3 1 -0.5 1.2) material))
  (define (sphere material) (Sphere (Float3 0.7 0.3 1) 0.4 material))
  (define (box material) (Box (Float3 -0.3 0.2 0.8) (Float3 0.6 0.9 1.1) material))
  (define (mesh material)
    (Mesh (flvector -1.0 -1.0 1.2  1.0 -1.0 1.4  1.0 1.0 1.2  -1.0 1.0 1.6)
          (fxvector 0 2 1 0 3 2) #:material material))
  (define kinds (list quad slanted disk triangle sphere box mesh))

  ;; A floor that is rough enough to find lights by scattering and by sampling, and beside the light
  ;; in its group something that casts a shadow.
  (define floor (Disk origin (Float3 0 0 1) 20 (RoughConductor 0.6)))
  (define shade (Sphere (Float3 0.2 -0.5 0.6) 0.25 (Lambertian (Float3 0.5 0.3 0.2))))

  (define camera
    (Camera-look-at (Float3 0.9 -0.7 0.5) (Float3 0.1 0.1 0) #:up (Float3 0 0 1)
                    #:vertical-field-of-view-degrees 4))
  (define side 64)
  (define (picture shapes [camera camera])
    (render (World (cons floor shapes) '() black) camera #:width side #:height side #:samples 2
            #:integrator 'path #:max-depth 3 #:schedule 'sequential))
  (define (greens image)
    (for*/list ([y side] [x side])
      (define-values (r g b) (Image-pixel image x y))
      g))
  (define (lights shapes) (light-count (World shapes '() black)))
  (define (variance values) (expt (standard-deviation values) 2))

  ;; The same picture but for what rounding makes of a shadow or a choice.
  (define (check-same name plain wrapped [camera camera])
    (check-equal? (lights wrapped) (lights plain) (format "~a: lights sampled" name))
    (define-values (a b) (values (greens (picture plain camera)) (greens (picture wrapped camera))))
    (define off
      (for/sum ([x a] [y b]) (if (> (abs (- x y)) (* 1e-6 (+ 1e-3 x))) 1 0)))
    (check-true (<= off 4) (format "~a: ~a of ~a pixels differ" name off (* side side)))
    (define error (sqrt (+ (expt (standard-error a) 2) (expt (standard-error b) 2))))
    (check-true (<= (abs (- (mean a) (mean b))) (* 4 error)) (format "~a: mean" name))
    (check-= (/ (variance b) (variance a)) 1.0 0.1 (format "~a: variance" name)))

  (define turn (Transform-compose (Transform-translate 0.3 -0.2 0.1)
                                  (Transform-rotate (Float3 1 2 3) 0.7)
                                  (Transform-scale 1.3)))
  (define back (Transform-inverse turn))

  (for* ([kind kinds] [material (list shining both)])
    (define name (object-name kind))
    (define light (kind material))
    (define plain (list shade light))
    (test-case (format "~a in a group" name)
      (check-same name plain (list (Group (list shade light)))))
    (test-case (format "~a in groups in a group" name)
      (check-same name plain (list (Group (list (Group (list shade)) (Group (list light)))))))
    (test-case (format "~a in an instance that moves and stretches" name)
      (define away (Transform-compose (Transform-translate 5 6 7) (Transform-scale 0.01)))
      (check-same name plain
                  (list shade (Instance (Group (list (Instance light (Transform-inverse away))))
                                        away))))
    (unless (eq? kind box)
      (test-case (format "~a in instances that turn, one in another" name)
        (check-same name plain (list shade (Instance (Group (list (Instance light turn))) back)))))
    (test-case (format "~a in an instance that mirrors, with its material" name)
      (define mirror (Transform-scale -1 1 1))
      (define mirrored (Instance (kind (Float3 1 1 1)) mirror))
      (check-same name plain (list shade (Instance mirrored mirror #:material material)))
      ;; seen from where left and right are alike
      (define middle
        (Camera-look-at (Float3 0 -1 0.7) (Float3 0 0.1 0) #:up (Float3 0 0 1)
                        #:vertical-field-of-view-degrees 30))
      (define-values (a b)
        (values (greens (picture (list light) middle))
                (greens (picture (list (Instance light mirror)) middle))))
      (define error (sqrt (+ (expt (standard-error a) 2) (expt (standard-error b) 2))))
      (check-equal? (lights (list (Instance light mirror))) 1)
      (check-true (<= (abs (- (mean a) (mean b))) (* 4 error)) (format "~a mirrored: mean" name))
      (check-= (/ (variance b) (variance a)) 1.0 0.2 (format "~a mirrored: variance" name))))

  (test-case "a lamp far from the origin, close over a floor, does not shadow itself"
    (define far (Float3 1e5 -3e4 2e4))
    (define (at x y z) (Float3-add far (Float3 x y z)))
    (define ground (Disk far (Float3 0 0 1) 20 (Lambertian (Float3 0.5 0.5 0.5))))
    (define eye
      (Camera-look-at (at 0.03 -0.02 0.012) (at 0.01 0.01 0) #:up (Float3 0 0 1)
                      #:vertical-field-of-view-degrees 4))
    (for ([light (list (Quad (at -1 -1 0.02) (Float3 0 2 0) (Float3 2 0 0) shining)
                       (Disk (at 0 0 0.02) (Float3 0 0 -1) 1 shining)
                       (Sphere (at 0 0 1.02) 1 shining)
                       (Box (at -1 -1 0.02) (at 1 1 1) shining))]
          [out (list turn turn turn (Transform-scale 3 2 0.5))])
      (check-same "far away" (list ground light)
                  (list ground (Instance (Instance light out) (Transform-inverse out)))
                  eye)))

  (test-case "instances of one group of lights: each light is its own"
    (define lamp (Group (list (Sphere (Float3 0 0 1) 0.2 shining) shade
                              (Disk (Float3 0.4 0 1.1) (Float3 0 0 -1) 0.2 both))))
    (define places (list (Transform-translate -0.6 0 0) (Transform-translate 0.5 0.2 0.1)
                         (Transform-translate 0 0.8 0.3)))
    (define plain
      (append* (for/list ([place places])
                 (for/list ([shape (Group-shapes lamp)]) (Instance shape place)))))
    (check-same "three lamps" plain (for/list ([place places]) (Instance lamp place)))
    (check-equal? (lights (for/list ([place places]) (Instance lamp place))) 6))

  (test-case "what is no sampled light: dark groups, dark instances of lights, stretched spheres"
    (define stretch (Transform-scale 1 1 2))
    (define dark (Lambertian (Float3 0.5 0.5 0.5)))
    (check-equal? (lights (list (Group (list shade)) (Instance (sphere shining) stretch)
                                (Instance (sphere shining) turn #:material dark)
                                (Group (list (Instance (disk shining) stretch)))
                                (SolidUnion (sphere shining) (box shining))
                                (Moving (sphere shining) turn turn)))
                  0))

  (test-case "a stretched sphere beside a lamp in its group is found by scattering alone"
    (define stretch (Transform-scale 1 1 2))
    (define ball (Instance (Sphere (Float3 -0.4 0.4 0.4) 0.3 shining) stretch))
    (define-values (a b)
      (values (greens (picture (list (quad both) ball)))
              (greens (picture (list (Group (list ball (quad both))))))))
    (define error (sqrt (+ (expt (standard-error a) 2) (expt (standard-error b) 2))))
    (check-true (<= (abs (- (mean a) (mean b))) (* 4 error)))
    (check-= (/ (variance b) (variance a)) 1.0 0.1)))
