#lang typed/racket/base
;; A hierarchy as a tree of lists, for the tests.
(require racket/flonum racket/fixnum "../../private/world/hierarchy.rkt")

(provide hierarchy-tree hierarchy-depth hierarchy-data)

(define-type Tree (U (List 'leaf (Listof Flonum) (Listof Fixnum))
                     (List 'inner (Listof Flonum) Tree Tree)))

;; (list 'leaf box members) or (list 'inner box left right).
(: hierarchy-tree (-> FlVector Nonnegative-Fixnum Tree))
(define (hierarchy-tree boxes count)
  (define h (build-hierarchy boxes count))
  (define-values (bounds links order)
    (values (Hierarchy-bounds h) (Hierarchy-links h) (Hierarchy-order h)))
  (let tree : Tree ([node : Fixnum 0])
    (define link (fxvector-ref links node))
    (define box
      (for/list : (Listof Flonum) ([k (in-range 6)]) (flvector-ref bounds (+ k (* 6 node)))))
    (define members (link-count link))
    (define payload (link-payload link))
    (if (or (fx> members 0) (= count 0))
        (list 'leaf box
              (for/list : (Listof Fixnum) ([k (in-range members)])
                (fxvector-ref order (+ payload k))))
        (list 'inner box (tree (fx+ node 1)) (tree payload)))))

(: hierarchy-depth (-> FlVector Nonnegative-Fixnum Fixnum))
(define (hierarchy-depth boxes count) (Hierarchy-depth (build-hierarchy boxes count)))

;; All of its numbers, to tell two builds apart.
(: hierarchy-data (-> FlVector Nonnegative-Fixnum (List FlVector FxVector FxVector)))
(define (hierarchy-data boxes count)
  (define h (build-hierarchy boxes count))
  (list (Hierarchy-bounds h) (Hierarchy-links h) (Hierarchy-order h)))
