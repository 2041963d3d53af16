#lang racket/base
;; A place in the bytes of a text: tokens separated by blanks, lines counted for the errors.

(provide make-cursor
         cursor-path cursor-bytes cursor-pos cursor-line cursor-start cursor-stop
         cursor-token! cursor-next-line! cursor-rest! cursor-at-end? cursor-rewind-token!
         cursor-token=? cursor-decimal! cursor-finite! cursor-integer!
         cursor-start-line-at! cursor-fail cursor-fail-at cursor-found)

(require racket/fixnum
         racket/flonum
         "decimal.rkt"
         "file.rkt")

;; pos is where scanning goes on; [start, stop) is the last token. comment is the byte that starts a
;; comment at the beginning of a token, or -1; continue? says whether a backslash joins two lines.
(struct cursor (path bytes comment continue?
                     [pos #:mutable] [line #:mutable] [start #:mutable] [stop #:mutable])
  #:authentic)

(define (make-cursor path bytes #:comment [comment #f] #:continue? [continue? #f])
  (cursor path bytes (if comment (char->integer comment) -1) continue? 0 1 0 0))

(define newline 10)
(define backslash 92)
(define-syntax-rule (blank? b)
  (or (fx= b 32) (fx= b 9) (fx= b 13) (fx= b 11) (fx= b 12)))

;; Moves over the next token of this line; #f, staying at the line's end, when there is none.
(define (cursor-token! c)
  (define bytes (cursor-bytes c))
  (define end (bytes-length bytes))
  (let skip ([i (cursor-pos c)])
    (define b (if (fx< i end) (bytes-ref bytes i) newline))
    (cond
      [(blank? b) (skip (fx+ i 1))]
      [(fx= b newline) (set-token! c i i) #f]
      [(fx= b (cursor-comment c))
       (define stop (line-end bytes i end))
       (set-token! c stop stop)
       #f]
      [(and (fx= b backslash) (continuation c i))
       => (λ (next)
            (set-cursor-line! c (fx+ 1 (cursor-line c)))
            (skip next))]
      [else
       (let scan ([j (fx+ i 1)])
         (define b (if (fx< j end) (bytes-ref bytes j) newline))
         (cond
           [(or (fx= b newline) (blank? b) (and (fx= b backslash) (continuation c j)))
            (set-token! c i j)
            #t]
           [else (scan (fx+ j 1))]))])))

(define (set-token! c start stop)
  (set-cursor-start! c start)
  (set-cursor-stop! c stop)
  (set-cursor-pos! c stop))

;; Where the next line starts, when the backslash at i joins it to this one; or #f.
(define (continuation c i)
  (define bytes (cursor-bytes c))
  (define end (bytes-length bytes))
  (define (newline-at? j) (and (fx< j end) (fx= newline (bytes-ref bytes j))))
  (and (cursor-continue? c)
       (cond
         [(newline-at? (fx+ i 1)) (fx+ i 2)]
         [(and (newline-at? (fx+ i 2)) (fx= 13 (bytes-ref bytes (fx+ i 1)))) (fx+ i 3)]
         [else #f])))

(define (line-end bytes i end)
  (let loop ([i i])
    (if (and (fx< i end) (not (fx= newline (bytes-ref bytes i)))) (loop (fx+ i 1)) i)))

;; Moves to the start of the next line.
(define (cursor-next-line! c)
  (let loop ()
    (when (cursor-token! c) (loop)))
  (unless (cursor-at-end? c)
    (set-cursor-pos! c (fx+ 1 (cursor-pos c)))
    (set-cursor-line! c (fx+ 1 (cursor-line c)))))

(define (cursor-at-end? c)
  (fx= (cursor-pos c) (bytes-length (cursor-bytes c))))

;; Puts the last token back.
(define (cursor-rewind-token! c)
  (set-cursor-pos! c (cursor-start c)))

;; Moves to the end of the line; the bytes up to there without the blanks around them.
(define (cursor-rest! c)
  (define bytes (cursor-bytes c))
  (define end (line-end bytes (cursor-pos c) (bytes-length bytes)))
  (define start
    (let loop ([i (cursor-pos c)])
      (if (and (fx< i end) (blank? (bytes-ref bytes i))) (loop (fx+ i 1)) i)))
  (define stop
    (let loop ([i end])
      (if (and (fx> i start) (blank? (bytes-ref bytes (fx- i 1)))) (loop (fx- i 1)) i)))
  (set-token! c start stop)
  (set-cursor-pos! c end)
  (subbytes bytes start stop))

;; Is the last token this word, given in lower case? Letters of either case match when any-case? is.
(define (cursor-token=? c word [any-case? #f])
  (define bytes (cursor-bytes c))
  (define start (cursor-start c))
  (define length (bytes-length word))
  (and (fx= length (fx- (cursor-stop c) start))
       (let loop ([i 0])
         (or (fx= i length)
             (let ([b (bytes-ref bytes (fx+ start i))])
               (and (fx= (bytes-ref word i)
                         (if (and any-case? (fx<= 65 b) (fx<= b 90)) (fx+ b 32) b))
                    (loop (fx+ i 1))))))))

;; The next token of this line as a number; what names it in the error. The first may be infinite
;; or NaN, the second not.
(define (cursor-decimal! c what)
  (or (and (cursor-token! c)
           (parse-decimal (cursor-bytes c) (cursor-start c) (cursor-stop c)))
      (cursor-fail c "expected a number for ~a, found ~a" what (cursor-found c))))

(define (cursor-finite! c what)
  (define x (cursor-decimal! c what))
  (unless (fl= 0.0 (fl- x x))
    (cursor-fail c "expected a finite number for ~a, found ~a" what (cursor-found c)))
  x)

;; The next token of this line as an integer.
(define (cursor-integer! c what)
  (or (and (cursor-token! c)
           (parse-integer (cursor-bytes c) (cursor-start c) (cursor-stop c)))
      (cursor-fail c "expected an integer for ~a, found ~a" what (cursor-found c))))

;; Goes on at pos, the start of the line after this one.
(define (cursor-start-line-at! c pos)
  (set-token! c pos pos)
  (set-cursor-line! c (fx+ 1 (cursor-line c))))

;; Raises a user error at this line, or at another.
(define (cursor-fail c . message)
  (apply fail-at-line (cursor-path c) (cursor-line c) message))

(define (cursor-fail-at c line . message)
  (apply fail-at-line (cursor-path c) line message))

;; The last token for a message.
(define (cursor-found c)
  (cond
    [(fx< (cursor-start c) (cursor-stop c))
     (quote-bytes (cursor-bytes c) (cursor-start c) (cursor-stop c))]
    [(cursor-at-end? c) "the end of the file"]
    [else "the end of the line"]))
