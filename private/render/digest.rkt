#lang racket/base
;; A number that tells whether two worlds are the same, across processes: by everything they hold.
(require racket/flonum racket/fixnum file/sha1
         (only-in "../world/world.rkt" World? World-parts)
         (only-in "../shape/mesh.rkt" Mesh? Mesh-positions Mesh-triangles Mesh-normals Mesh-uvs
                  Mesh-material))

(provide content-digest)

;; content-digest : SHA-1 in hexadecimal digits of values made of numbers, text, lists, vectors, structs
;; whose fields can be seen, flvectors and fxvectors. A procedure or another value that cannot be looked
;; into counts by its kind only; where there is one, the bytes that `otherwise` returns count as well.
(define (content-digest values otherwise)
  (define seen (make-hasheq))
  (define opaque? #f)
  (define out (open-output-bytes))
  (define sum #"")
  (define (flush!)
    (set! sum (sha1-bytes (bytes-append sum (sha1-bytes (get-output-bytes out #t))))))
  (define (put kind . parts)
    (write kind out)
    (for ([part (in-list parts)]) (write part out))
    (when (> (file-position out) 1000000) (flush!)))
  (define (walk value)
    (cond
      [(or (number? value) (boolean? value) (symbol? value) (string? value) (bytes? value)
           (null? value) (char? value) (void? value))
       (put 'atom value)]
      [(hash-ref seen value #f) => (lambda (number) (put 'same number))]
      [else
       (hash-set! seen value (hash-count seen))
       (cond
         [(pair? value)
          (put 'pair)
          (walk (car value))
          (walk (cdr value))]
         [(vector? value) (put 'vector (vector-length value)) (for ([v (in-vector value)]) (walk v))]
         [(flvector? value)
          (put 'flvector (flvector-length value))
          (for ([x (in-flvector value)])
            (write-bytes (real->floating-point-bytes x 8 #f) out))
          (put 'end)]
         [(fxvector? value)
          (put 'fxvector (fxvector-length value))
          (for ([n (in-fxvector value)])
            (write-bytes (integer->integer-bytes n 8 #t #f) out))
          (put 'end)]
         ;; what these keep for later follows from the rest
         [(World? value)
          (put 'World)
          (for-each walk (World-parts value))]
         [(Mesh? value)
          (put 'Mesh)
          (for-each walk (list (Mesh-positions value) (Mesh-triangles value) (Mesh-normals value)
                               (Mesh-uvs value) (Mesh-material value)))]
         [(and (struct? value) (not (procedure? value)))
          (define parts (struct->vector value))
          (when (memq '... (vector->list parts)) (set! opaque? #t))
          (put 'struct (vector-length parts))
          (for ([part (in-vector parts)]) (walk part))]
         [else
          (set! opaque? #t)
          (put 'other (and (procedure? value) (object-name value)))])]))
  (for-each walk values)
  (when opaque? (write-bytes (otherwise) out))
  (flush!)
  (bytes->hex-string sum))
