#lang racket/base
;; The material files that OBJ files name: Kd Ks Ke Ns Ni and d or Tr of each material.

(provide read-mtl
         name-string)

(require racket/flonum
         "cursor.rkt"
         "file.rkt"
         "mesh-data.rkt"
         "warnings.rkt")

;; Adds the materials of the file, mesh-material by name, to the immutable hash known. Textures,
;; spectral colours and unknown words become warnings; what is malformed raises a user error.
(define (read-mtl path known warnings)
  (define bytes (load-file path))
  (define c (make-cursor path bytes #:comment #\# #:continue? #t))
  (let loop ([known known] [name #f] [material empty-material])
    (define (finished)
      (if name (hash-set known name material) known))
    (cond
      [(cursor-at-end? c) (finished)]
      [(not (cursor-token! c))
       (cursor-next-line! c)
       (loop known name material)]
      [(cursor-token=? c #"newmtl")
       (define new-name (name-string (cursor-rest! c)))
       (define before (finished))
       (cursor-next-line! c)
       (loop before new-name empty-material)]
      [else
       (define changed (read-property c name material warnings))
       (cursor-next-line! c)
       (loop known name changed)])))

(define empty-material (mesh-material #f #f #f #f #f #f))

;; The material after the line whose first word is the cursor's token.
(define (read-property c name material warnings)
  (define (word? word) (cursor-token=? c word))
  (define (needs-name)
    (unless name (cursor-fail c "expected newmtl before ~a" (cursor-found c))))
  (define (number what)
    (needs-name)
    (cursor-finite! c what))
  (define (colour what field)
    (needs-name)
    (read-colour c what (field material) warnings))
  (define-syntax-rule (with field value)
    (struct-copy mesh-material material [field value]))
  (cond
    [(word? #"Kd") (with Kd (colour "Kd" mesh-material-Kd))]
    [(word? #"Ks") (with Ks (colour "Ks" mesh-material-Ks))]
    [(word? #"Ke") (with Ke (colour "Ke" mesh-material-Ke))]
    [(word? #"Ns") (with Ns (number "Ns"))]
    [(word? #"Ni") (with Ni (number "Ni"))]
    [(word? #"Tr") (with d (fl- 1.0 (number "Tr")))]
    [(word? #"d")
     (unless (and (cursor-token! c) (word? #"-halo"))
       (cursor-rewind-token! c))
     (with d (number "d"))]
    [else
     (warn-about-word c warnings)
     material]))

;; One to three numbers: the first stands for those that are missing.
(define (read-colour c what old warnings)
  (define first? (cursor-token! c))
  (cond
    [(and first? (or (cursor-token=? c #"spectral") (cursor-token=? c #"xyz")))
     (warn-once! warnings 'spectral (cursor-path c) (cursor-line c)
                 "only RGB colours are read: ~a ~a is ignored" what (cursor-found c))
     old]
    [else
     (when first? (cursor-rewind-token! c))
     (define red (cursor-finite! c what))
     (define (next)
       (cond [(cursor-token! c) (cursor-rewind-token! c) (cursor-finite! c what)]
             [else red]))
     (define green (next))
     (list red green (next))]))

(define silent-words
  '(#"Ka" #"Tf" #"illum" #"sharpness" #"Pr" #"Pm" #"Ps" #"Pc" #"Pcr" #"aniso" #"anisor"))

(define texture-words '(#"bump" #"disp" #"decal" #"refl" #"norm"))

(define (warn-about-word c warnings)
  (define word (subbytes (cursor-bytes c) (cursor-start c) (cursor-stop c)))
  (cond
    [(member word silent-words) (void)]
    [(or (regexp-match? #rx#"^map_" word) (member word texture-words))
     (warn-once! warnings 'texture (cursor-path c) (cursor-line c)
                 "textures are not read: ~a is ignored" (cursor-found c))]
    [else
     (warn-once! warnings (cons 'mtl word) (cursor-path c) (cursor-line c)
                 "unknown word ~a is ignored" (cursor-found c))]))

;; The bytes of a name as a string; distinct bytes give distinct strings.
(define (name-string bytes)
  (with-handlers ([exn:fail:contract? (λ (_) (bytes->string/latin-1 bytes))])
    (bytes->string/utf-8 bytes)))
