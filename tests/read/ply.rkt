#lang racket/base
;; PLY: golden meshes in text and both binary orders, and the errors of every kind.

(module+ test
  (require rackunit
           racket/flonum
           "../../private/read/mesh.rkt"
           "mesh-files.rkt")

  (define (lines . strings)
    (apply string-append (for/list ([s (in-list strings)]) (string-append s "\n"))))

  (define (numbers type big? . values)
    (apply bytes-append
           (for/list ([v (in-list values)])
             (case type
               [(byte) (bytes (bitwise-and v 255))]
               [(short) (integer->integer-bytes v 2 (< v 0) big?)]
               [(int) (integer->integer-bytes v 4 (< v 0) big?)]
               [(float) (real->floating-point-bytes v 4 big?)]
               [(double) (real->floating-point-bytes v 8 big?)]))))

  (define corners '((0.0 0.0 0.0) (1.0 0.0 0.0) (1.0 1.0 0.0) (0.0 1.0 0.0)))

  (test-case "text"
    (define mesh
      (read-bytes-as
       ".ply"
       (lines "ply" "format ascii 1.0" "comment element nonsense" "obj_info more" "element vertex 4"
              "property float x" "property double y" "property int z" "element face 2"
              "property list uchar int vertex_indices" "end_header"
              "0 0 0" "1 0 0" "" " 1 1e0 0 " "0 1 0" "3 0 1 2" "3 0 2 3" "" " ")))
    (check-equal? (position-list mesh) corners)
    (check-equal? (triangle-list mesh) '((0 1 2) (0 2 3)))
    (check-false (mesh-data-normals mesh))
    (check-false (mesh-data-uvs mesh))
    (check-equal? (mesh-data-groups mesh) '((#f 0 2)))
    (check-equal? (mesh-data-materials mesh) (hash))
    (check-equal? (mesh-data-warnings mesh) '()))

  (test-case "text with CRLF, every property in another order, unknown ones, a quad"
    (define mesh
      (read-bytes-as
       ".ply"
       (regexp-replace*
        #rx"\n"
        (lines "ply" "format ascii 1.0" "element camera 1" "property list int float lens"
               "property float far" "element vertex 4" "property uchar red" "property float t"
               "property float nz" "property float z" "property float s" "property float y"
               "property list uchar int tags" "property float x" "property float nx"
               "property float ny" "element nothing 1000000000" "element face 1" "property int id"
               "property list uchar uint vertex_index" "property list uchar float texcoord"
               "element edge 1" "property int a" "end_header"
               "2 0.5 0.5 7"
               "255 0.1 1 0 0.2 0 0 0 0 0" "255 0.3 2 0 0.4 0 1 9 1 0 0" "255 0.5 3 0 0.6 1 0 1 0 0"
               "255 0.7 4 0 0.8 1 3 1 2 3 0 0 0"
               "42 4 0 1 2 3 2 0.5 0.5"
               "3")
        "\r\n")))
    (check-equal? (position-list mesh) corners)
    (check-equal? (triangle-list mesh) '((0 1 2) (0 2 3)))
    (check-equal? (mesh-data-uvs mesh) (flvector 0.2 0.1 0.4 0.3 0.6 0.5 0.8 0.7))
    (check-equal? (mesh-data-normals mesh)
                  (flvector 0.0 0.0 1.0 0.0 0.0 2.0 0.0 0.0 3.0 0.0 0.0 4.0)))

  ;; Every type, lists to skip, a float list length; the first data byte looks like a line end.
  (define (binary big?)
    (define (n type . values) (apply numbers type big? values))
    (bytes-append
     (string->bytes/utf-8
      (lines "ply" (format "format binary_~a_endian 1.0" (if big? "big" "little"))
             "element first 1" "property char a" "property list ushort double b" "property float64 c"
             "element vertex 4" "property int8 x" "property float texture_u" "property int16 y"
             "property uint8 skipped" "property float32 texture_v" "property uint32 z"
             "element face 1" "property list short ushort other"
             "property list float int16 vertex_indices" "property float32 last" "end_header"))
     (n 'byte 10) (n 'short 2) (n 'double 1.0 2.0 3.0)
     (apply bytes-append
            (for/list ([p (in-list '((-1 -300 0) (1 -300 0) (1 300 4000000000) (-1 300 4000000000)))]
                       [u (in-list '(0.0 1.0 2.0 3.0))])
              (bytes-append (n 'byte (car p)) (n 'float u) (n 'short (cadr p)) (n 'byte 200)
                            (n 'float (+ u 0.5)) (n 'int (caddr p)))))
     (n 'short 1 65535) (n 'float 4.0) (n 'short 3 2 1 0) (n 'float 0.0)))

  (test-case "both binary orders, every type"
    (for ([big? (in-list '(#f #t))])
      (define mesh (read-bytes-as ".ply" (binary big?)))
      (check-equal? (position-list mesh)
                    '((-1.0 -300.0 0.0) (1.0 -300.0 0.0) (1.0 300.0 4e9) (-1.0 300.0 4e9)))
      (check-equal? (mesh-data-uvs mesh) (flvector 0.0 0.5 1.0 1.5 2.0 2.5 3.0 3.5))
      (check-equal? (triangle-list mesh) '((3 2 1) (3 1 0)))))

  (test-case "every shorter binary file is an error"
    (define whole (binary #t))
    (for ([length (in-range (bytes-length whole))])
      (check-one-line-error ".ply" (subbytes whole 0 length) "" "expected")))

  (define (header format vertices faces . more)
    (string-append
     (lines "ply" (string-append "format " format " 1.0") (~vertices vertices) "property float x"
            "property float y" "property float z" (~faces faces)
            "property list uchar int vertex_indices")
     (apply lines more)
     (lines "end_header")))
  (define (~vertices n) (string-append "element vertex " n))
  (define (~faces n) (string-append "element face " n))

  (test-case "degenerate triangles"
    (define mesh
      (read-bytes-as ".ply" (string-append (header "ascii" "4" "4")
                                           (lines "0 0 0" "1 0 0" "2 0 0" "0 1 0"
                                                  "3 0 1 2" "3 0 1 3" "3 1 1 3" "3 3 2 1"))))
    (check-equal? (triangle-list mesh) '((0 1 3) (3 2 1)))
    (check-equal? (mesh-data-dropped mesh) 2)
    (check-equal? (length (mesh-data-warnings mesh)) 1))

  (define (check content place expected)
    (check-one-line-error ".ply" content place expected))

  (test-case "errors of the header"
    (check "" "1: " "expected ply as the first word of the file, found the end of the file")
    (check "plx\n" "1: " "expected ply")
    (check "ply\nformat ascii 2.0\n" "2: " "expected format version 1.0")
    (check "ply\nformat text 1.0\n" "2: " "expected ascii, binary_little_endian or")
    (check "ply\nelement\n" "2: " "expected format")
    (check "ply\nformat ascii 1.0\nelement vertex\n" "3: "
           "expected an integer for the number of rows")
    (check "ply\nformat ascii 1.0\nelement vertex -1\n" "3: " "expected a number of rows from 0")
    (check "ply\nformat ascii 1.0\nelement vertex 12345678901234567890\n" "3: " "expected an integer")
    (check "ply\nformat ascii 1.0\nproperty int x\n" "3: " "expected element before property")
    (check "ply\nformat ascii 1.0\nelement a 1\nproperty real x\n" "4: " "expected a type such as")
    (check "ply\nformat ascii 1.0\nelement a 1\nproperty list int x\n" "4: "
           "expected a type such as")
    (check "ply\nformat ascii 1.0\nelement a 1\nproperty int\n" "4: "
           "expected the name of the property")
    (check "ply\nformat ascii 1.0\nelement a 1\nelement a 1\n" "4: " "expected each element once")
    (check "ply\nformat ascii 1.0\nelement a 1\nproperty int x\nproperty int x\n" "5: "
           "expected each property once")
    (check "ply\nformat ascii 1.0\nelement a 1\n" "4: " "expected the rest of the header")
    (check "ply\nformat ascii 1.0\nend_header\n" "3: " "expected element vertex")
    (check "ply\nformat ascii 1.0\nelement vertex 0\nproperty int x\nelement face 0\nend_header\n"
           "3: " "expected element vertex to have numbers x, y and z")
    (check (lines "ply" "format ascii 1.0" "element vertex 0" "property int x" "property int y"
                  "property int z" "element face 0" "property int vertex_indices" "end_header")
           "7: " "expected element face to have a list")
    (check (lines "ply" "format ascii 1.0" "element face 0" "property list int int vertex_indices"
                  "element vertex 0" "property int x" "property int y" "property int z" "end_header")
           "3: " "expected element vertex before element face")
    (check (header "ascii" "0" "0") "7: " "expected at least one face"))

  (test-case "counts beyond the file, before anything is allocated"
    (for ([format (in-list '("ascii" "binary_little_endian" "binary_big_endian"))])
      (define before (current-memory-use 'cumulative))
      (check (string-append (header format "1000000000" "1") "0 0 0\n") "3: "
             "expected 1000000000 rows of at least ")
      (check (string-append (header format "1" "10000000000000000") "0 0 0\n0 0 0\n") "7: "
             "expected 10000000000000000 rows of at least ")
      (check-true (< (- (current-memory-use 'cumulative) before) 20000000))))

  (define vertices (lines "0 0 0" "1 0 0" "0 1 0"))
  (define (check-text rows place expected)
    (check (string-append (header "ascii" "3" "1") rows) place expected))

  (test-case "errors in the rows of a text"
    (check-text "0 0 0\n1 0 0\n0 1\n3 0 1 2\n" "12: "
                "expected a number for z, found the end of the line")
    (check-text "0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n" "11: "
                "expected a finite number for z of vertex 1")
    (check-text "0 0 0\n1 0 x\n0 1 0\n3 0 1 2\n" "11: " "expected a number for z, found \"x\"")
    (check-text (string-append "0 0 0 0\n" vertices) "10: "
                "expected the end of the row, found \"0\"")
    (check-text (string-append vertices "3 0 1 3\n") "13: "
                "expected a vertex index from 0 to 2, found 3")
    (check-text (string-append vertices "3 0 1 -1\n") "13: "
                "expected a vertex index from 0 to 2, found -1")
    (check-text (string-append vertices "3 0 1 1.5\n") "13: "
                "expected an integer for a vertex index")
    (check-text (string-append vertices "2 0 1\n") "13: " "expected at least 3 corners for face 0")
    (check-text (string-append vertices "4 0 1 2\n") "13: " "expected an integer for a vertex index")
    (check-text (string-append vertices "3 0 1 2\n3 0 1 2\n") "14: "
                "expected the end of the file after the rows announced, found \"3\"")
    (check-text (string-append vertices " \n") "14: "
                "expected another row, found the end of the file")
    (check-text (string-append vertices "3 0 0 2\n") "7: " "expected at least one face with an area"))

  (test-case "errors in the rows of a binary file"
    (define head (string->bytes/utf-8 (header "binary_little_endian" "3" "1")))
    (define start (bytes-length head))
    (define (n type . values) (apply numbers type #f values))
    (define points (n 'float 0.0 0.0 0.0 1.0 0.0 0.0 0.0 1.0 0.0))
    (define (check-binary body offset expected)
      (check (bytes-append head body) (format " byte ~a: " (+ start offset)) expected))
    (check-binary (bytes-append (n 'float 0.0 +nan.0) (make-bytes 28 0) (n 'byte 3) (n 'int 0 1 2)) 4
                  "expected a finite number for y of vertex 0, found +nan.0")
    (check-binary (bytes-append points (n 'byte 3) (n 'int 0 1 3)) 45
                  "expected a vertex index from 0 to 2, found 3")
    (check-binary (bytes-append points (n 'byte 3) (n 'int 0 -1 2)) 41
                  "expected a vertex index from 0 to 2, found -1")
    (check-binary (bytes-append points (n 'byte 4) (n 'int 0 1 2)) 49
                  "expected 4 bytes for a vertex index, found the end of the file after 0")
    (check-binary (bytes-append points (n 'byte 0)) 36
                  "expected at least 3 corners for face 0, found 0")
    (check-binary (bytes-append points (n 'byte 3) (n 'int 0 1 2) #"\n \1") 49
                  "found 3 more bytes")
    (check-true (mesh-data? (read-bytes-as ".ply" (bytes-append head points (n 'byte 3) (n 'int 0 1 2)
                                                                #"\r\n"))))))
