#lang racket/base
;; Scaling: racket tests/bench/scaling.rkt [--rounds N] [FILE] renders one picture by the real command on
;; 1 and 2 futures, 2 places, 2 parts at a time and 2 hosts (an ssh server on 127.0.0.1), one after the
;; other in every round, and writes the medians as a table in Markdown to FILE (scaling.md by default):
;; seconds on the clock and CPU seconds, those of hosts included; the efficiency by either, one future
;; being 100%; what a render of a single pixel takes, which is the start; and what a tile costs more than
;; its pixels, by the CPU seconds with tiles of two sizes.
(require compiler/find-exe racket/cmdline racket/file racket/format racket/future racket/list racket/port
         racket/string "../faults/ssh-server.rkt")

;; What everything is measured on.
(define SCENE '("weekend" "--samples" "16" "--quiet"))
(define LARGE 16)
(define SMALL 4)
(define (tiles side) (* (ceiling (/ 320 side)) (ceiling (/ 180 side))))

;; What is rendered: the picture with tiles of either size, and one pixel.
(define TASKS
  (hasheq 'large (list "--size" "320x180" "--tile" (number->string LARGE))
          'small (list "--size" "320x180" "--tile" (number->string SMALL))
          'start '("--size" "1x1")))

(define (median numbers) (list-ref (sort numbers <) (quotient (length numbers) 2)))

;; Runs the command in the folder, at once for several lists of words: (list seconds CPU-seconds). What
;; node-racket notes of hosts in the file `times` there counts as well.
(define (run folder . lists)
  (define start (current-inexact-monotonic-milliseconds))
  (define cpu (+ (children-seconds) (host-seconds folder)))
  (define running
    (for/list ([words (in-list lists)])
      (define-values (process out in err)
        (parameterize ([current-directory folder])
          (apply subprocess #f #f #f (find-exe) "-N" "raco" "-l-" "raytrace/private/command/main" words)))
      (close-output-port in)
      (define said (open-output-string))
      (define pumps (for/list ([from (in-list (list out err))]) (thread (lambda () (copy-port from said)))))
      (list process pumps said)))
  (for ([one (in-list running)])
    (subprocess-wait (car one))
    (for-each thread-wait (cadr one))
    (unless (zero? (subprocess-status (car one))) (error (get-output-string (caddr one)))))
  (list (/ (- (current-inexact-monotonic-milliseconds) start) 1000.0)
        (begin
          (sleep 1) ; hosts end a little later
          (- (+ (children-seconds) (host-seconds folder)) cpu))))

;; The CPU seconds of processes that this one started and that have ended.
(define (children-seconds)
  (define fields (string-split (cadr (regexp-match #rx"[)] (.*)$" (file->string "/proc/self/stat")))))
  (/ (+ (string->number (list-ref fields 13)) (string->number (list-ref fields 14))) 100.0))

;; The CPU seconds that hosts' workers took so far, as the shell's `times` tells: 0m1.23s 0m0.12s.
(define (host-seconds folder)
  (define file (build-path folder "times"))
  (for/sum ([time (in-list (if (file-exists? file)
                               (regexp-match* #px"([0-9]+)m([0-9.]+)s" (file->string file)
                                              #:match-select cdr)
                               '()))])
    (+ (* 60.0 (string->number (car time))) (string->number (cadr time)))))

;; A way to render: its name, workers, and a procedure that does with the words of a task.
(struct way (name workers render))

(define (ways folder)
  (define ((scheduled schedule workers) task)
    (run folder (append SCENE task (list "--schedule" schedule "--workers" workers "-o" "a.pfm"))))
  (define (in-parts task)
    (define (part k)
      (append SCENE task (list "--workers" "1" "--part" (format "~a/2" k) "-o" (format "~a.part" k))))
    (map + (run folder (part 1) (part 2)) (run folder '("merge" "1.part" "2.part" "-o" "a.pfm"))))
  (list (way "1 future" 1 (scheduled "futures" "1"))
        (way "2 futures" 2 (scheduled "futures" "2"))
        (way "2 places" 2 (scheduled "places" "2"))
        (way "2 parts" 2 in-parts)
        (way "2 hosts" 2 (scheduled "hosts:hosts" "1"))))

;; measure : for each way a hash from the tasks to the medians (list seconds CPU-seconds).
(define (measure rounds)
  (define folder (make-temporary-file "scaling~a" 'directory))
  (define (host name)
    (define command
      (node-racket folder name
                   #:last (format "~a \"$@\"; times >> ~a" (find-executable-path "racket")
                                  (build-path folder "times"))))
    (format "~a 1 ~a" name command))
  (dynamic-wind
   void
   (lambda ()
     (display-lines-to-file (list (host "node-a") (host "node-b")) (build-path folder "hosts"))
     (call-with-ssh-server folder (lambda () (measure-ways folder rounds))))
   (lambda () (delete-directory/files folder))))

(define (measure-ways folder rounds)
  (define all (ways folder))
  (define found (make-hash))
  (define whole #f)
  (for* ([round (in-range rounds)] [task (in-list '(start large small))] [way (in-list all)])
    (define hosts-before (host-seconds folder))
    (define times ((way-render way) (hash-ref TASKS task)))
    (eprintf "~a, ~a: ~a s, CPU ~a s, ~a s of it on hosts\n" (way-name way) task (first times) (second times)
             (- (host-seconds folder) hosts-before))
    (unless (eq? task 'start)
      (define picture (file->bytes (build-path folder "a.pfm")))
      (unless whole (set! whole picture))
      (unless (equal? picture whole) (error (way-name way) "another picture")))
    (hash-update! found (cons way task) (lambda (others) (cons times others)) '()))
  (define (medians way task)
    (define runs (hash-ref found (cons way task)))
    (list (median (map car runs)) (median (map cadr runs))))
  (for/list ([way (in-list all)])
    (cons way (for/hasheq ([task (in-hash-keys TASKS)]) (values task (medians way task))))))

(define (write-table rows out)
  (define (number x places) (~r x #:precision (list '= places)))
  (define (percent x) (format "~a%" (~r (* 100 x) #:precision 0)))
  (define alone (hash-ref (cdr (first rows)) 'large))
  (fprintf out "weekend, 320x180, 16 samples, tiles of ~a; ~a processors\n\n" LARGE (processor-count))
  (fprintf out "| ways | clock s | CPU s | by clock | by CPU | start, CPU s | a tile, CPU ms |\n")
  (fprintf out "|---|---|---|---|---|---|---|\n")
  (for ([row (in-list rows)])
    (define way (car row))
    (define-values (start large small)
      (apply values (for/list ([task (in-list '(start large small))]) (hash-ref (cdr row) task))))
    (fprintf out "| ~a | ~a | ~a | ~a | ~a | ~a | ~a |\n" (way-name way)
             (number (first large) 2) (number (second large) 2)
             (percent (/ (first alone) (first large) (way-workers way)))
             (percent (/ (second alone) (second large)))
             (number (second start) 2)
             (number (/ (* 1000 (- (second small) (second large))) (- (tiles SMALL) (tiles LARGE))) 3))))

(module+ main
  (define rounds 3)
  (define file
    (command-line #:once-each [("--rounds") n "Renders of each kind, 3 by default"
                                            (set! rounds (string->number n))]
                  #:args ([file "scaling.md"]) file))
  (define rows (measure rounds))
  (write-table rows (current-output-port))
  (call-with-output-file file #:exists 'truncate (lambda (out) (write-table rows out))))
