#lang racket/base
;; Mutated mesh files and pictures of every format: each loads or gives one line that names the file.
;; What loads is a sound mesh, or a picture that a texture can be made of.

(provide cases)

(require racket/class racket/file racket/flonum "case.rkt" "../../main.rkt" "../read/sphere-files.rkt"
         (only-in "../image/support.rkt" repaired))

(define SECONDS 10) ; for one file, after which it counts as a hang

(define number-bytes #"0123456789.-e/")
(define tokens
  (vector #"\n" #" " #"\\\n" #"-" #"1e400" #" nan" #"inf" #"999999999" #"4294967295" #"/" #"#" #"\0"
          #"f 1 2 3\n" #"f -1 -2 -3\n" #"usemtl x\n" #"element vertex 1000000000\n"
          #"\377\377\377\177" #"\0\0\300\177" #"endsolid\n"))

;; A copy with one to four changes: bytes replaced, removed, put in, doubled, bits turned, the end
;; cut off.
(define (mutate original pick)
  (for/fold ([content original]) ([_ (in-range (+ 1 (pick 4)))])
    (define size (bytes-length content))
    (define at (pick (+ size 1)))
    (define end (min size (+ at 1 (pick (vector-ref #(1 6 60) (pick 3))))))
    (define-values (before within after)
      (values (subbytes content 0 at) (subbytes content at end) (subbytes content end)))
    (define (noise n) (apply bytes (for/list ([_ (in-range n)]) (pick 256))))
    (case (pick 8)
      [(0) (bytes-append before (noise (- end at)) after)]
      [(1) (bytes-append before after)]
      [(2) (bytes-append before within within after)]
      [(3) (bytes-append before (vector-ref tokens (pick (vector-length tokens))) within after)]
      [(4) (if (= 0 (pick 4)) before content)]
      [else
       (define turned
         (for/list ([b (in-bytes within)] [k (in-naturals)])
           (cond
             [(> k 0) b]
             [(= 0 (pick 2)) (bitwise-xor b (arithmetic-shift 1 (pick 8)))]
             [else (bytes-ref number-bytes (pick (bytes-length number-bytes)))])))
       (bytes-append before (apply bytes turned) after)])))

;; 'loaded, 'refused, or what went wrong as text.
(define (outcome path)
  (define result #f)
  (define reading
    (thread
     (lambda ()
       (set! result
             (with-handlers ([exn:fail? values])
               (if (picture? path) (ImageTexture (Image-read path)) (Mesh-read path)))))))
  (define ended? (sync/timeout SECONDS reading))
  (kill-thread reading)
  (cond
    [(not ended?) "hangs"]
    [(not (exn? result)) (if (sound? result) 'loaded "is read, but is not sound")]
    [(not (exn:fail:user? result)) (format "raises ~e" result)]
    [(regexp-match? #rx"^[^\n\r]*/mesh[.][a-z]+:[^\n\r]*expected[^\n\r]*$" (exn-message result))
     'refused]
    [else (format "says ~s" (exn-message result))]))

(define (picture? path) (regexp-match? #rx"[.](hdr|ppm|pfm|png|jpg)$" path))

;; A picture has as many numbers as its size says; those of a PFM may be anything.
(define (sound? content)
  (define (finite? numbers) (for/and ([x (in-flvector numbers)]) (< (abs x) +inf.0)))
  (cond
    [(ImageTexture? content)
     (define image (ImageTexture-image content))
     (= (flvector-length (Image-pixels image)) (* 3 (Image-width image) (Image-height image)))]
    [(Mesh? content) (finite? (Mesh-positions content))]
    [else (andmap sound? (Group-shapes content))]))

;; `featured`: an OBJ file with materials; its material file is the one that is mutated in turn.
(define featured
  (list (cons "mesh.obj"
              (bytes-append #"mtllib mesh.mtl\no a\nv 0 0 0 1\nv 4 2 0\nv 0 4 0\nv 1 2 0\n"
                            #"vt 0 0\nvt 1 0\nvn 0 0 1\ng b\nusemtl red\nf 1/1/1 2/2/1 3//1 4/1/1\n"
                            #"usemtl blue\nf -4 -3 \\\n -1\ns 1\nl 1 2\nf 1//1 2//1 3//1 3//1\n"))
        (cons "mesh.mtl"
              (bytes-append #"newmtl red\nKd 1 0 0\nKs .5\nNs 10\nmap_Kd a.png\n"
                            #"newmtl blue\nd 0.5\nNi 1.5\nKe 1 2 3\nTr 0.5\nillum 2\n"))))

;; Radiance lines of every kind: encoded channels, flat pixels, repeated ones.
(define radiance
  (bytes-append #"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=2.5\nCOLORCORR=1 .9 1.1\n\n"
                #"-Y 3 +X 12\n"
                (bytes 2 2 0 12 140 128  3 1 2 3 137 9  139 7 1 8  140 129)
                (apply bytes (for/list ([k (in-range 48)]) (+ 5 (modulo (* 29 k) 247))))
                (bytes 200 100 50 130 1 1 1 4 9 9 9 120 1 1 1 6)))

;; A small picture in the bytes of a format.
(define (picture-bytes extension)
  (define path (make-temporary-file (string-append "picture~a." extension)))
  (define image
    (render (World (list (Sphere (Float3 0 0 0) 1 (Lambertian (Float3 0.7 0.3 0.2)))) '()
                   (Float3 0.4 0.6 1))
            (Camera-look-at (Float3 0 0 5) (Float3 0 0 0)) #:width 20 #:height 12 #:samples 1
            #:integrator 'path #:schedule 'sequential))
  (dynamic-wind
   void
   (lambda ()
     (if (equal? extension "jpg")
         (send (Image->bitmap image) save-file path 'jpeg 90)
         (Image-write image path))
     (file->bytes path))
   (lambda () (delete-file path))))

;; Mutates the file called `name` of the files; `mesh` is the one that is read. finish is applied to
;; three mutants of four.
(define (mutations size files name mesh [finish values])
  (define generator (make-pseudo-random-generator))
  (parameterize ([current-pseudo-random-generator generator]) (random-seed 1985))
  (define (pick n) (random n generator))
  (define folder (make-temporary-file "stress-~a" 'directory))
  (define (write-file! name content)
    (call-with-output-file (build-path folder name) #:exists 'truncate
      (lambda (out) (write-bytes content out))))
  (define path (build-path folder mesh))
  (dynamic-wind
   void
   (lambda ()
     (for ([file (in-list files)]) (write-file! (car file) (cdr file)))
     (define unchanged (outcome path))
     (define original (cdr (assoc name files)))
     (for/fold ([loaded 0] [refused 0] [wrong (if (eq? unchanged 'loaded) '() (list unchanged))])
               ([k (in-range (amount 10000 size 100))])
       (define mutant (mutate original pick))
       (write-file! name (if (= 0 (remainder k 4)) mutant (finish mutant)))
       (define found (outcome path))
       (case found
         [(loaded) (values (+ loaded 1) refused wrong)]
         [(refused) (values loaded (+ refused 1) wrong)]
         [else (values loaded refused (cons found wrong))])))
   (lambda () (delete-directory/files folder))))

(define (sphere-bytes kind)
  (define path (make-temporary-file "sphere-~a"))
  (dynamic-wind void
                (lambda () (write-sphere kind 4 path) (file->bytes path))
                (lambda () (delete-file path))))

(define ((files-case kind) size)
  (define-values (loaded refused wrong)
    (case kind
      [(obj-materials) (mutations size featured "mesh.obj" "mesh.obj")]
      [(hdr) (mutations size (list (cons "mesh.hdr" radiance)) "mesh.hdr" "mesh.hdr")]
      [(mtl) (mutations size featured "mesh.mtl" "mesh.obj")]
      [(ppm pfm png jpg)
       (define name (format "mesh.~a" kind))
       (mutations size (list (cons name (picture-bytes (symbol->string kind)))) name name
                  (if (eq? kind 'png) repaired values))]
      [else
       (define name (string-append "mesh." (substring (symbol->string kind) 0 3)))
       (mutations size (list (cons name (sphere-bytes kind))) name name)]))
  (values (format "~a loaded, ~a refused, ~a wrong~a" loaded refused (length wrong)
                  (if (null? wrong) "" (format " (~a)" (car wrong))))
          (and (null? wrong) (> refused 0) (> loaded 0))))

(define cases
  (for/list ([kind (in-list (append sphere-kinds '(obj-materials mtl hdr ppm pfm png jpg)))])
    (stress-case (format "files ~a" kind) "0 but loaded or refused in one line" (files-case kind))))
