#lang racket/base
;; OBJ and its material files: golden meshes of every feature, and the errors of every kind.

(module+ test
  (require rackunit
           racket/flonum
           "../../private/read/mesh.rkt"
           "mesh-files.rkt")

  (define (read-obj . lines)
    (define ended (for/list ([line (in-list lines)]) (string-append line "\n")))
    (read-bytes-as ".obj" (apply string-append ended)))

  (define square "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0")

  (test-case "a triangle"
    (define mesh (read-obj "v 0 0 0" "v 1 0 0.5" "v -.5e0 1. 2" "f 1 2 3"))
    (check-equal? (position-list mesh) '((0.0 0.0 0.0) (1.0 0.0 0.5) (-0.5 1.0 2.0)))
    (check-equal? (triangle-list mesh) '((0 1 2)))
    (check-false (mesh-data-normals mesh))
    (check-false (mesh-data-uvs mesh))
    (check-equal? (mesh-data-groups mesh) '((#f 0 1)))
    (check-equal? (mesh-data-dropped mesh) 0)
    (check-equal? (mesh-data-warnings mesh) '()))

  (test-case "w, colours, comments, continued lines, CRLF, no last line end, blanks"
    (define mesh
      (read-bytes-as ".obj" (string-append "# a comment with a \\\r\n\r\n  v 0 0 0 1\r\n"
                                           "v 1 0 0 .1 .2 .3\r\n"
                                           "\tv 1 \\\r\n1 0 # end\r\nf 1 2\\\r\n 3")))
    (check-equal? (position-list mesh) '((0.0 0.0 0.0) (1.0 0.0 0.0) (1.0 1.0 0.0)))
    (check-equal? (triangle-list mesh) '((0 1 2))))

  (test-case "polygons, convex and concave"
    (check-equal? (triangle-list (read-obj square "f 1 2 3 4")) '((0 1 2) (0 2 3)))
    (define arrow (read-obj "v 0 0 0" "v 4 2 0" "v 0 4 0" "v 1 2 0" "f 1 2 3 4"))
    ;; Only the diagonal from 2 to 4 lies inside.
    (define at (for/list ([i (in-list '((0.0 0.0 0.0) (4.0 2.0 0.0) (0.0 4.0 0.0) (1.0 2.0 0.0)))])
                 (for/first ([p (in-list (position-list arrow))] [k (in-naturals)]
                             #:when (equal? p i)) k)))
    (check-equal? (for/list ([t (in-list (triangle-list arrow))])
                    (and (memv (cadr at) t) (memv (cadddr at) t) #t))
                  '(#t #t)))

  (test-case "indices from the end"
    (define mesh (read-obj "v 9 9 9" square "f -4 -3 -2" "v 5 5 5" "f -1 -2 -3"))
    (check-equal? (position-list mesh)
                  '((0.0 0.0 0.0) (1.0 0.0 0.0) (1.0 1.0 0.0) (5.0 5.0 5.0) (0.0 1.0 0.0)))
    (check-equal? (triangle-list mesh) '((0 1 2) (3 4 2))))

  (define vt "vt 0 0\nvt 1 0\nvt 1 1 0.5\nvt 0.25")
  (define vn "vn 0 0 1\nvn 0 0 2")

  (test-case "v/vt"
    (define mesh (read-obj square vt "f 1/1 2/2 3/4"))
    (check-equal? (mesh-data-uvs mesh) (flvector 0.0 0.0 1.0 0.0 0.25 0.0))
    (check-false (mesh-data-normals mesh)))

  (test-case "v//vn"
    (define mesh (read-obj square vn "f 1//1 2//2 3//-1"))
    (check-false (mesh-data-uvs mesh))
    (check-equal? (mesh-data-normals mesh) (flvector 0.0 0.0 1.0 0.0 0.0 2.0 0.0 0.0 2.0)))

  (test-case "v/vt/vn: one vertex for each triple"
    (define mesh
      (read-obj square vt vn "f 1/1/1 2/2/1 3/3/1" "f 1/1/1 3/3/1 4/4/1" "f 1/1/2 3/3/1 4/1/1"))
    (check-equal? (triangle-list mesh) '((0 1 2) (0 2 3) (4 2 5)))
    (check-equal? (list-ref (position-list mesh) 4) '(0.0 0.0 0.0))
    (check-equal? (list-ref (position-list mesh) 5) '(0.0 1.0 0.0))
    (check-equal? (mesh-data-uvs mesh)
                  (flvector 0.0 0.0 1.0 0.0 1.0 1.0 0.25 0.0 0.0 0.0 0.0 0.0))
    (check-equal? (flvector-ref (mesh-data-normals mesh) 14) 2.0))

  (test-case "normals of some corners only are dropped, and do not split vertices"
    (define mesh (read-obj square vn "f 1//1 2//1 3//1" "f 1//2 3//2 4"))
    (check-false (mesh-data-normals mesh))
    (check-equal? (triangle-list mesh) '((0 1 2) (0 2 3)))
    (check-regexp-match #rx"/mesh.obj:9: 1 of 6 corners have no normal"
                        (car (mesh-data-warnings mesh))))

  (test-case "zero and NaN normals are dropped with a warning"
    (for ([bad (in-list '("vn 0 0 0" "vn nan 0 1" "vn 0 inf 1"))])
      (define mesh (read-obj square bad "f 1//1 2//1 3//1"))
      (check-false (mesh-data-normals mesh))
      (check-regexp-match #rx"3 zero or non-finite normals" (car (mesh-data-warnings mesh)))))

  (test-case "texture coordinates of some corners only: 0 0 for the others"
    (define mesh (read-obj square vt "f 1/3 2/3 3"))
    (check-equal? (mesh-data-uvs mesh) (flvector 1.0 1.0 1.0 1.0 0.0 0.0))
    (check-regexp-match #rx"1 of 3 corners have no texture" (car (mesh-data-warnings mesh))))

  (test-case "degenerate triangles are dropped and counted; groups follow"
    (define mesh
      (read-obj square "v 2 0 0" "v 0 0 0" "usemtl a" "f 1 1 2" "f 1 2 5" "usemtl b" "f 1 2 3"
                "f 1 6 2" "f 1 3 4" "usemtl c" "f 2 2 2" "usemtl b" "f 1 2 4" "usemtl a" "f 2 3 4"))
    (check-equal? (mesh-data-dropped mesh) 4)
    (check-equal? (length (triangle-list mesh)) 4)
    (check-equal? (mesh-data-groups mesh) '(("b" 0 3) ("a" 3 1)))
    (check-true (for/or ([w (in-list (mesh-data-warnings mesh))])
                  (regexp-match? #rx"4 degenerate triangles were dropped" w))))

  (test-case "words passed over, and one warning for each unknown one"
    (define mesh
      (read-obj "o name" "g a b" "s off" "l 1 2" "p 1" square "foo 1" "foo 2" "bar" "f 1 2 3"))
    (check-equal? (length (mesh-data-warnings mesh)) 2)
    (check-regexp-match #rx"/mesh.obj:10: unknown word \"foo\" is ignored"
                        (car (mesh-data-warnings mesh))))

  (test-case "warnings have an end"
    (define mesh
      (apply read-obj square "f 1 2 3" (for/list ([i (in-range 1000)]) (format "word~a" i))))
    (check-equal? (length (mesh-data-warnings mesh)) 21))

  (define mtl
    (string-append "# materials\nnewmtl red\nKd 1 0 0.25\nKs 0.5\nNs 32\nd 0.5\nNi 1.5\nKe 2 3 4\n"
                   "Ka 1 1 1\nillum 2\nmap_Kd red.png\nmap_Ks x.png\n"
                   "newmtl glass pane\r\nTr 0.75\r\nwhat 1\nnewmtl none\nd -halo 0.25\nKd xyz 1 1\n"))

  (define textured
    (string-append square "\nmtllib a.mtl\nf 1 2 3\nusemtl red\nf 1 2 4\nusemtl glass pane\nf 1 3 4\n"
                   "mtllib none.mtl a.mtl\nusemtl other\nf 2 3 4\n"))

  (test-case "materials"
    (define mesh (read-bytes-as ".obj" textured
                                #:beside (list (cons "a.mtl" (string->bytes/utf-8 mtl)))))
    (define materials (mesh-data-materials mesh))
    (define (fields name)
      (define m (hash-ref materials name))
      (list (mesh-material-Kd m) (mesh-material-Ks m) (mesh-material-Ns m) (mesh-material-d m)
            (mesh-material-Ni m) (mesh-material-Ke m)))
    (check-equal? (fields "red") '((1.0 0.0 0.25) (0.5 0.5 0.5) 32.0 0.5 1.5 (2.0 3.0 4.0)))
    (check-equal? (fields "glass pane") '(#f #f #f 0.25 #f #f))
    (check-equal? (fields "none") '(#f #f #f 0.25 #f #f))
    (check-equal? (hash-count materials) 3)
    (check-equal? (mesh-data-groups mesh)
                  '((#f 0 1) ("red" 1 1) ("glass pane" 2 1) ("other" 3 1)))
    (define patterns
      '(#rx"/a.mtl:11: textures are not read: \"map_Kd\"" #rx"/a.mtl:15: unknown word \"what\""
        #rx"/a.mtl:18: only RGB colours are read: Kd \"xyz\""
        #rx"material file \"none.mtl\" is missing"
        #rx"material \"other\" is not defined"))
    (check-equal? (length (mesh-data-warnings mesh)) (length patterns))
    (for ([pattern (in-list patterns)] [warning (in-list (mesh-data-warnings mesh))])
      (check-regexp-match pattern warning)))

  (test-case "a missing material file is a warning, a malformed one an error"
    (define mesh (read-bytes-as ".obj" textured))
    (check-equal? (length (triangle-list mesh)) 4)
    (check-regexp-match #rx"/mesh.obj:5: material file \"a.mtl\" is missing"
                        (car (mesh-data-warnings mesh)))
    (for ([content (in-list '(#"newmtl a\nKd red\n" #"newmtl a\nNs nan" #"\nd 1"
                              #"newmtl a\nKd 1 2 x"))])
      (check-exn #rx"^[^\n]*/a.mtl:2: expected [^\n]*$"
                 (λ () (read-bytes-as ".obj" textured #:beside (list (cons "a.mtl" content)))))))

  (test-case "names that are no paths"
    (for ([name (in-list '("" "a\0b" "/" ".." "\\"))])
      (define mesh (read-obj square (string-append "mtllib " name) "f 1 2 3"))
      (check-equal? (triangle-list mesh) '((0 1 2)))))

  ;; A comb of long diagonal teeth: the box around each ear holds every other tooth.
  (test-case "an outline whose search would be quadratic is given up"
    (define teeth 10000)
    (define (vertex x y) (format "v ~a ~a 0\n" (+ x y) (- y x)))
    (define vertices
      (append (for*/list ([i (in-range teeth)] [tip (in-list '(0 1))])
                (vertex (+ (* 2 i) tip) (* 100000 tip)))
              (list (vertex (* 2 teeth) 0) (vertex (* 2 teeth) -1) (vertex 0 -1))))
    (define corners (for/list ([i (in-range (length vertices))]) (format " ~a" (+ i 1))))
    (check-one-line-error ".obj" (apply string-append (append vertices (list "f") corners)) "20004: "
                          "expected an outline that can be triangulated, found 20003 corners"))

  (test-case "errors"
    (define (check content place expected)
      (check-one-line-error ".obj" content place expected))
    (define (after-square line place expected)
      (check (string-append square "\n" line "\n") place expected))
    (check "" "1: " "expected at least one face")
    (check "v 0 0 0\n" "2: " "expected at least one face")
    (after-square "f 1 1 2" "6: " "expected at least one face with an area")
    (check "v 0 0\n" "1: " "expected a number for z, found the end of the line")
    (check "v 0 0" "1: " "expected a number for z, found the end of the file")
    (check "\nv 0 x 0\n" "2: " "expected a number for y, found \"x\"")
    (check "v 0 nan 0\n" "1: " "expected a finite number for y, found \"nan\"")
    (check "v 0 0 1e999\n" "1: " "expected a finite number for z, found \"1e999\"")
    (check "v 0 0 -inf\n" "1: " "expected a finite number for z, found \"-inf\"")
    (check "vn 1 2\n" "1: " "expected a number for the normal's z")
    (check "vt\n" "1: " "expected a number for u")
    (after-square "f 1 2" "5: " "expected a face of at least 3 corners, found 2")
    (after-square "f 1 2 5" "5: " "expected a v index within the 4 defined so far, found 5")
    (after-square "f 1 2 -5" "5: " "expected a v index within the 4 defined so far, found -5")
    (after-square "f 1 2 99999999999999999999999" "5: " "expected a v index within")
    (after-square "f 1 2/1 3" "5: " "expected a vt index within the 0 defined so far, found 1")
    (after-square "f 1 2//1 3" "5: " "expected a vn index within the 0 defined so far, found 1")
    (for ([corner (in-list '("0" "1.0" "1/x" "a" "-" "/1" "1/-" "1////" "1//0"))])
      (after-square (string-append "f 1 2 " corner) "5: "
                    "expected a corner v, v/vt, v//vn or v/vt/vn"))
    (check "v 0 0 0\\\n\\\n\nv 0" "4: " "expected a number for y")))
