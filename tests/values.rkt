#lang racket/base
;; Public values as a user meets them: every constructor's value prints as an expression that makes
;; an equal one, compares with equal?, and refuses bad arguments in one line that names the
;; constructor and the argument.
(module+ test
  (require racket/flonum racket/fixnum racket/list racket/match racket/string rackunit raytrace
           "../private/arguments.rkt")

  (define-namespace-anchor here)
  (define namespace (namespace-anchor->namespace here))

  (define p (Float3 0.1 -2 1/3))
  (define q (Float3 1.7 0.3 2))
  (define slanted (Float3 0.3 0.7 -0.2))
  (define red (Float3 0.8 0.1 0.05))
  (define dark (Float3 0.1 0.05 0.02))
  (define ball (Sphere p 1.1 (Metal red 0.3)))
  (define turn (Transform-compose (Transform-rotate slanted #:degrees 33)
                                  (Transform-translate 1 2 3.3)))
  (define mesh
    (Mesh (flvector 0.0 0.0 0.0 1.0 0.0 0.0 0.0 1.0 0.0) (fxvector 0 1 2)
          #:normals (flvector 0.0 0.1 1.0 0.0 0.0 1.0 0.0 0.0 1.0) #:material (Mirror)))

  ;; constructor's name -> values of it
  (define examples
    (hasheq
     'Float3 (list p (Float3 -0.0 1e-300 1e300))
     'Camera (list (Camera p slanted q (Float3 0 1 0))
                   (Camera-look-at p q #:lens-radius 0.1)
                   (Camera-fisheye p q #:field-of-view-degrees 140)
                   (Camera-moving (Camera-look-at p q)
                                  (Camera-with (Camera-look-at p slanted) #:shutter-close 0.4)))
     'Ray (list (Ray p slanted 0.25))
     'Intersection (list (Intersection 2 p slanted red))
     'Sphere (list ball (Sphere p 2) (Sphere p 2 red))
     'Plane (list (Plane p slanted red))
     'Disk (list (Disk p slanted 0.7 #:material (Lambertian red)))
     'Quad (list (Quad p slanted q red))
     'Triangle (list (Triangle p slanted q))
     'Box (list (Box (Float3 -1 -2 -3) q (Dielectric 1.5)))
     'Cylinder (list (Cylinder p q 0.4 red) (Cylinder p q 0.4 #:caps? #f))
     'Cone (list (Cone p 0.4 q red) (Cone p 0.4 q #:caps? #f))
     'Torus (list (Torus p slanted 2 0.3 red))
     'Mesh (list mesh)
     'Group (list (Group (list ball (Box (Float3 0 0 0) (Float3 1 1 1)))))
     'Instance (list (Instance ball turn) (Instance mesh turn #:material (Mirror red)))
     'Moving (list (Moving ball (Transform-identity) (Transform-translate 0 1 0)))
     'SolidUnion (list (SolidUnion ball ball))
     'SolidIntersection (list (SolidIntersection ball ball #:material red))
     'SolidDifference (list (SolidDifference ball (Group (list ball))))
     'DistantLight (list (DistantLight slanted red))
     'PointLight (list (PointLight p red))
     'SpotLight (list (SpotLight p slanted red 0.7 0.3))
     'Phong (list (Phong red) (Phong red 0.4 20 #:reflectivity 0.2))
     'Emitter (list (Emitter (Float3 5 4 3)) (Emitter (Float3 5 4 3) #:two-sided? #t)
                    (Emitter (Float3 5 4 3) #:surface (Lambertian red)))
     'Lambertian (list (Lambertian red) (Lambertian (Checker red dark #:size 2)))
     'Mirror (list (Mirror) (Mirror red))
     'Metal (list (Metal red 0.2))
     'Dielectric (list (Dielectric 1.5) (Dielectric 1.33 #:fresnel 'schlick #:absorption red))
     'Plastic (list (Plastic red 1.4))
     'ModifiedPhong (list (ModifiedPhong red dark 40))
     'Mix (list (Mix (Lambertian red) (Mirror) 0.3))
     'Bumped (list (Bumped (Mirror) (Noise red dark)) (Bumped (Lambertian red) (UVTexture) -0.2))
     'RoughConductor (list (RoughConductor 0.2) (RoughConductor (Checker red dark)) (gold 0.1))
     'RoughDielectric (list (RoughDielectric 1.5 0.2))
     'Checker (list (Checker red dark 2))
     'CheckerUV (list (CheckerUV red dark 4) (CheckerUV red dark 4 #:rows 3))
     'Noise (list (Noise red dark 2 #:octaves 3))
     'Turbulence (list (Turbulence red dark))
     'Marble (list (Marble red dark #:bands 3))
     'GradientTexture (list (GradientTexture red dark)
                            (GradientTexture red dark #:start p #:end q))
     'UVTexture (list (UVTexture))
     'Medium (list (Medium 0.4 red) (Medium dark red #:anisotropy 0.6))
     'Interior (list (Interior (Medium 0.4 red)) (Interior (Medium 1 red) (Dielectric 1.5)))
     'GradientSky (list (GradientSky red dark))
     'World (list (World) (World (list ball mesh) (DistantLight slanted red) dark)
                  (World (list ball) '() (GradientSky red dark) #:ambient-color red
                         #:ambient-samples 4 #:max-occlusion-distance +inf.0
                         #:ambient-weighting 'cosine #:occlusion-falloff 'binary
                         #:shadow-samples 3 #:mirror-bounces 2)
                  (World (list ball) #:medium (Medium 0.01 red)))))

  ;; What holds a procedure or a picture prints that part as what it is.
  (define unreadable '(DistanceShape CustomShape FunctionTexture ImageTexture EnvironmentMap))

  (define (text value)
    (define out (open-output-string))
    (print value out)
    (get-output-string out))
  (define (rebuilt text)
    (parameterize ([current-namespace namespace] [read-accept-reader #f])
      (eval (read (open-input-string text)))))

  (test-case "every constructor has an example here"
    (for ([name (in-list (constructor-names))])
      (check-true (or (hash-has-key? examples name) (and (memq name unreadable) #t))
                  (format "~a" name))))

  (test-case "values print as expressions that make equal values"
    (for* ([(name values) (in-hash examples)] [value (in-list values)])
      (define printed (text value))
      (check-regexp-match (format "^[(]~a[ )]" name) printed)
      (check-equal? (rebuilt printed) value printed)
      (check-equal? (equal-hash-code (rebuilt printed)) (equal-hash-code value) printed)
      ;; and so do lists of them, and pretty-printed ones
      (check-equal? (rebuilt (text (list value))) (list value))))

  (define (image value)
    (render (World '() '() (Float3 value value value))
            (Camera-look-at (Float3 0 0 1) (Float3 0 0 0)) #:width 2 #:height 1 #:samples 1))

  (test-case "what has no expression says what it is"
    (check-regexp-match #rx"^[(]DistanceShape #<procedure:" 
                        (text (DistanceShape (lambda (x y z) 1.0) p q)))
    (check-regexp-match #rx"#:lipschitz 2.0" 
                        (text (DistanceShape (lambda (x y z) 1.0) p q #:lipschitz 2)))
    (define grey (flomap->Image (Image->flomap (Images-side-by-side (list (image 0.5))))))
    (check-regexp-match #rx"^[(]EnvironmentMap #<Image 2x1> #:rotation-degrees 37.3[)]$"
                        (text (EnvironmentMap grey #:rotation-degrees 37.3)))
    (define fine (build-list 101 (lambda (k) k)))
    (check-equal? (text (Mesh (make-flvector 9) (apply fxvector (append* (map (lambda (k) '(0 1 2)) fine)))))
                  "#<Mesh: 101 triangles, 3 vertices>"))

  (test-case "worlds and meshes that differ are not equal"
    (check-not-equal? (World (list ball)) (World (list ball ball)))
    (check-not-equal? (World (list ball)) (World (list ball) #:shadow-samples 2))
    (check-not-equal? mesh (Mesh (Mesh-positions mesh) (Mesh-triangles mesh)))
    (check-not-equal? (Transform-translate 1 2 3) (Transform-translate 1 2 4)))

  (test-case "values match"
    (check-equal? (match (World (list ball) '() dark) [(World (list (Sphere c r _)) _ b) (list c r b)])
                  (list p 1.1 dark))
    (check-equal? (match (Cylinder p q 0.4 #:caps? #f) [(Cylinder a b r _ caps?) (list a b r caps?)])
                  (list p q 0.4 #f)))

  ;; --------------------------------------------------------------------------------------------

  (define constructor-of
    (for/hasheq ([name (in-list (constructor-names))])
      (values name (eval name namespace))))

  ;; Good arguments by kind.
  (define (good argument kind)
    (case kind
      [(real) (case argument
                [(minor-radius falloff-angle) 0.2] [(fuzz roughness time lens-radius) 0.5]
                [else 1.5])]
      [(share) 0.5] [(mirror) 0.5] [(whole) 3] [(flags) #t] [(name) 'bilinear] [(fresnel) 'exact]
      [(vector) (case argument
                  [(point corner a base center low eye start) (Float3 0 0 0)]
                  [(edge-u b) (Float3 1 0 0)] [(edge-v c) (Float3 0 1 0)]
                  [else (Float3 1 2 3)])]
      [(color paint surface) dark] [(material) (Mirror)] [(shape) ball] [(shapes) (list ball)]
      [(medium) (Medium 0.4 red)]
      [(lights) '()] [(background) dark] [(transform) turn] [(camera) (Camera-look-at p q)]
      [(image) (image 0.5)]
      [(texture) (UVTexture)]
      [(procedure) (lambda (x y z) 1.0)]
      [(flvector) (flvector 0.0 0.0 0.0)] [(fxvector) (fxvector 0 0 0)]))

  ;; How the constructor fails with those arguments: the message, or #f where it does not.
  (define (complaint name arguments)
    (with-handlers ([exn:fail:contract? exn-message])
      (apply (hash-ref constructor-of name) arguments)
      #f))

  (define (good-arguments places)
    (for/list ([argument (in-list places)]) (good (car argument) (last argument))))
  (define (places-of name)
    (filter (lambda (argument) (symbol? (car argument))) (constructor-signature name)))

  (define (accepts? name count)
    (define message (complaint name (good-arguments (take (places-of name) count))))
    (not (and message (regexp-match? #rx"expected (the|no) arguments" message))))
  (define (required-places name)
    (take (places-of name) (for/first ([k (in-naturals)] #:when (accepts? name k)) k)))

  (define (check-complaint name argument value message)
    (with-check-info (['constructor name] ['argument argument] ['value value])
      (check-true (string? message))
      (when (string? message)
        (check-regexp-match (format "^~a: expected " name) message)
        (check-true (string-contains? message (format "~a" argument)) message)
        (check-false (string-contains? message "\n") message)
        (check-true (< (string-length message) 300) message))))

  (test-case "a wrong kind of argument is named, by place and by keyword"
    (for* ([name (in-list (constructor-names))]
           [value (in-list (list "text" (vector 1 2)))])
      (define places (places-of name))
      (define required (required-places name))
      (for ([bad (in-range (length places))])
        (define arguments
          (for/list ([argument (in-list (take places (max (+ bad 1) (length required))))]
                     [k (in-naturals)])
            (if (= k bad) value (good (car argument) (last argument)))))
        (when (accepts? name (length arguments))
          (check-complaint name (car (list-ref places bad)) value (complaint name arguments))))
      (for ([argument (in-list (constructor-signature name))] #:when (keyword? (car argument)))
        (define message
          (with-handlers ([exn:fail:contract? exn-message])
            (keyword-apply (hash-ref constructor-of name) (list (car argument)) (list value)
                           (good-arguments required))
            #f))
        (check-complaint name (keyword->string (car argument)) value message))))

  (test-case "numbers out of range are named: no number, infinities, negative sizes"
    (for ([name (in-list (constructor-names))]
          ;; any numbers are vectors and intersections; a colour from outside its range is looked at
          ;; where it is used
          #:unless (memq name '(Float3 Intersection)))
      (define required (required-places name))
      (for* ([bad (in-range (length required))]
             [argument (in-value (list-ref required bad))]
             [value (in-list
                     (case (last argument)
                       [(real) (list +nan.0 +inf.0 -inf.0 -1)]
                       [(color paint vector)
                        (list (Float3 +nan.0 0 0) (Float3 0 +nan.0 1) (Float3 0 0 -inf.0))]
                       [else '()]))]
             #:unless (and (eq? name 'CustomShape) (memq (car argument) '(low high))))
        (define arguments
          (for/list ([argument (in-list required)] [k (in-naturals)])
            (if (= k bad) value (good (car argument) (last argument)))))
        (check-complaint name (car argument) value (complaint name arguments)))))

  (test-case "too few and too many arguments, and unknown keywords"
    (check-exn #rx"^Sphere: expected the arguments point radius [(]material[)], given 1$"
               (lambda () (Sphere p)))
    (check-exn #rx"^GradientSky: expected the arguments bottom top, given 3$"
               (lambda () (GradientSky p p p)))
    (check-exn #rx"^Sphere: expected one of [(]#:material[)] as keyword, given '#:colour$"
               (lambda () (Sphere p 1 #:colour red)))))
