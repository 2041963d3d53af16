#lang racket/base
;; STL, text and binary: golden meshes, telling the two apart, and the errors of every kind.

(module+ test
  (require rackunit
           "../../private/read/mesh.rkt"
           "mesh-files.rkt")

  (define (facet . corners)
    (string-append "facet normal nan nan nan\n outer loop\n"
                   (apply string-append
                          (for/list ([c (in-list corners)]) (string-append "  vertex " c "\n")))
                   " endloop\nendfacet\n"))

  (define two-facets
    (string-append (facet "0 0 0" "1 0 0" "1 1 -0") (facet "-0 0 0" "1 1 0" "0.0 1e0 0")))

  (define expected-positions
    '((0.0 0.0 0.0) (1.0 0.0 0.0) (1.0 1.0 0.0) (0.0 1.0 0.0)))

  (define (check-square mesh)
    (check-equal? (position-list mesh) expected-positions)
    (check-equal? (triangle-list mesh) '((0 1 2) (0 2 3)))
    (check-false (mesh-data-normals mesh))
    (check-false (mesh-data-uvs mesh))
    (check-equal? (mesh-data-groups mesh) '((#f 0 2)))
    (check-equal? (mesh-data-warnings mesh) '()))

  (test-case "text: equal corners are one vertex, 0 and -0 are equal"
    (check-square
     (read-bytes-as ".stl" (string-append "solid a name\n" two-facets "endsolid a name\n")))
    (check-square (read-bytes-as ".stl" (string-append "solid\n" two-facets "endsolid"))))

  (test-case "text: capitals, CRLF, several solids, odd line ends"
    (define text (string-append "solid a\n" (facet "0 0 0" "1 0 0" "1 1 0") "endsolid a\n\n"
                                "solid b\n" (facet "0 0 0" "1 1 0" "0 1 0") "endsolid b\n"))
    (check-square (read-bytes-as ".stl" text))
    (check-square (read-bytes-as ".stl" (string-upcase text)))
    (check-square (read-bytes-as ".stl" (regexp-replace* #rx"\n" text "\r\n")))
    (check-square (read-bytes-as ".stl" (regexp-replace* #rx"([0-9]) " text "\\1\n"))))

  (define (binary header count . corners)
    (bytes-append
     header (make-bytes (- 80 (bytes-length header)) 32)
     (integer->integer-bytes count 4 #f #f)
     (apply bytes-append
            (for/list ([triangle (in-list corners)])
              (bytes-append (make-bytes 12 255)
                            (apply bytes-append
                                   (for/list ([x (in-list triangle)])
                                     (real->floating-point-bytes x 4 #f)))
                            #"ab")))))

  (define square-corners
    '((0.0 0.0 0.0 1.0 0.0 0.0 1.0 1.0 -0.0) (-0.0 0.0 0.0 1.0 1.0 0.0 0.0 1.0 0.0)))

  (test-case "binary, whatever its header says; its normals are not looked at"
    (for ([header (in-list '(#"" #"solid x" #"solid facet normal 0 0 0 outer loop vertex"))])
      (check-square (read-bytes-as ".stl" (apply binary header 2 square-corners)))))

  (test-case "degenerate triangles"
    (define mesh
      (read-bytes-as ".stl" (binary #"" 3 (car square-corners) '(0.0 0.0 0.0 1.0 1.0 1.0 2.0 2.0 2.0)
                                    '(5.0 5.0 5.0 5.0 5.0 5.0 1.0 2.0 3.0))))
    (check-equal? (triangle-list mesh) '((0 1 2)))
    (check-equal? (mesh-data-dropped mesh) 2))

  (define (check content place expected)
    (check-one-line-error ".stl" content place expected))

  (test-case "errors in binary files"
    (check "" " byte 0: " "found an empty file")
    (check "hello" " byte 0: " "expected the word solid, or the 84 bytes that start a binary STL")
    (define whole (apply binary #"solid" 2 square-corners))
    (check (subbytes whole 0 183) " byte 80: "
           "expected 184 bytes for the 2 triangles announced, found a file of 183 bytes")
    (check (bytes-append whole #"x") " byte 80: " "found a file of 185 bytes")
    (define before (current-memory-use 'cumulative))
    (check (binary #"" 1000000000) " byte 80: " "expected 50000000084 bytes")
    (check-true (< (- (current-memory-use 'cumulative) before) 20000000))
    (check (binary #"" 1 '(0.0 0.0 0.0 1.0 +nan.0 0.0 1.0 1.0 0.0)) " byte 112: "
           "expected a finite coordinate, found +nan.0")
    (check (binary #"" 1 '(0.0 0.0 0.0 1.0 0.0 0.0 1.0 1.0 -inf.0)) " byte 128: "
           "expected a finite coordinate, found -inf.0")
    (check (binary #"" 0) " byte 84: " "expected at least one triangle with an area, found none"))

  (test-case "errors in texts"
    (define (check-text facets place expected)
      (check (string-append "solid x\n" facets "endsolid\n") place expected))
    (check-text "" "3: " "expected at least one facet")
    (check-text (facet "0 0 0" "1 1 1" "2 2 2") "10: " "expected at least one facet with an area")
    (check-text (facet "0 0 0" "1 1 x" "2 2 2") "5: " "expected a number for z, found \"x\"")
    (check-text (facet "0 0 0" "1 1" "2 2 2") "6: " "expected a number for z, found \"vertex\"")
    (check-text (facet "0 0 0" "1 inf 1" "2 2 2") "5: "
                "expected a finite number for y, found \"inf\"")
    (check-text (facet "0 0 0" "1 1 1") "6: " "expected vertex, found \"endloop\"")
    (check-text (facet "0 0 0" "1 0 0" "1 1 0" "0 1 0") "7: " "expected endloop, found \"vertex\"")
    (check-text "face\n" "2: " "expected facet or endsolid, found \"face\"")
    (check "solid x\n" "2: " "expected facet or endsolid, found the end of the file")
    (check "solid x\nfacet normal 0 0" "2: " "expected a normal, found the end of the file")
    (check "solid x\nendsolid x\nmore\n" "3: " "expected solid, found \"more\"")
    (check "solid x\n facet normal 0 0 0 outer loop vertex" "2: "
           "expected a number for x, found the end of the file")))
