:- module(painted,
          [ painted/7                   % see below
          ]).
:- use_module(reader_words).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(pairs)).
:- use_module(library(yall)).
/* The machine of PDF and PostScript, for tests: see drawing_reader.pl. */

%   painted(Content, Kind, Defs, H, Labels, Fills, Paths): what a page of
%   height H shows; operators are those of PDF, or of PostScript with Defs.

painted(Content, Kind, Defs, H, Labels, Fills, Paths) :-
    split_string(Content, "", "", [Text0]),
    spaced(Text0, Text),
    words(Text, Words),
    State = machine{ stack: [], matrix: [1,0,0,1,0,0], rgb: [0,0,0],
                     fill: [0,0,0], width: 1, cap: 0, join: 0, dash: [],
                     offset: 0, layer: none, path: [], out: [], fills: [],
                     how: how(Kind,Defs,Labels), height: H },
    run(Words, State, End),
    must(End.stack == [], left(End.stack)),
    must(End.path == [], unpainted),
    must(End.layer == none, open_layer),
    reverse(End.out, Paths),
    reverse(End.fills, Fills).

spaced(Text0, Text) :-
    split_string(Text0, "[", "", As),
    atomic_list_concat(As, ' [ ', Text1),
    split_string(Text1, "]", "", Bs),
    atomic_list_concat(Bs, ' ] ', Text).

run([], State, State).
run([Word|Words], State0, State) :-
    (   number_string(Number, Word)
    ->  State1 = State0.put(stack, [Number|State0.stack]),
        Words1 = Words
    ;   sub_string(Word, 0, 1, _, "/")
    ->  State1 = State0.put(stack, [Word|State0.stack]),
        Words1 = Words
    ;   Word == "["
    ->  append(Inside0, ["]"|Words1], Words),
        !,
        maplist(number_of, Inside0, Inside),
        State1 = State0.put(stack, [array(Inside)|State0.stack])
    ;   State0.how = how(ps,Defs,_),
        memberchk(Word-Body, Defs)
    ->  append(Body, Words, Words1),
        State1 = State0
    ;   State0.how = how(Kind,_,_),
        operator(Kind, Word, Stack, Stack1, State0, Changed)
    ->  must(append(_, Stack1, State0.stack), stack(Word)),
        must(Stack = State0.stack, stack(Word, State0.stack)),
        State1 = Changed,
        Words1 = Words
    ;   throw(wrong(operator(Word)))
    ),
    !,
    run(Words1, State1, State).

%   operator(Kind, Word, Before, After, State0, State): Before is the stack.

operator(pdf, Word, Stack, _, State0, State) :-
    pdf_operator(Word, Name),
    !,
    Stack = State0.stack,
    act(Name, State0, State).
operator(ps, Word, Stack, _, State0, State) :-
    Stack = State0.stack,
    atom_string(Name, Word),
    act(Name, State0, State).

pdf_operator("cm", cm).
pdf_operator("m", moveto).
pdf_operator("l", lineto).
pdf_operator("h", closepath).
pdf_operator("S", stroke).
pdf_operator("w", setlinewidth).
pdf_operator("J", setlinecap).
pdf_operator("j", setlinejoin).
pdf_operator("d", setdash).
pdf_operator("RG", setrgbcolor).
pdf_operator("rg", setfill).
pdf_operator("re", re).
pdf_operator("f", fill).
pdf_operator("BDC", begin_layer).
pdf_operator("EMC", end_layer).

act(cm, S0, S) :-
    S0.stack = [F,E,D,C,B,A|Stack],
    multiply([A,B,C,D,E,F], S0.matrix, M),
    S = S0.put(_{stack:Stack, matrix:M}).
act(array, S0, S) :-
    S0.stack = [N|Stack],
    S = S0.put(stack, [room(N)|Stack]).
act(astore, S0, S) :-
    S0.stack = [room(N)|Stack0],
    length(Last, N),
    append(Last, Stack, Stack0),
    reverse(Last, Array),
    S = S0.put(stack, [array(Array)|Stack]).
act(concat, S0, S) :-
    S0.stack = [array(A)|Stack],
    multiply(A, S0.matrix, M),
    S = S0.put(_{stack:Stack, matrix:M}).
act(pop, S0, S) :-
    S0.stack = [_|Stack],
    S = S0.put(stack, Stack).
act(dup, S0, S) :-
    S0.stack = [A|Stack],
    S = S0.put(stack, [A,A|Stack]).
act(exch, S0, S) :-
    S0.stack = [B,A|Stack],
    S = S0.put(stack, [A,B|Stack]).
act(neg, S0, S) :-
    S0.stack = [A|Stack],
    B is -A,
    S = S0.put(stack, [B|Stack]).
act(roll, S0, S) :-
    S0.stack = [J,N|Stack0],
    length(Top, N),
    append(Top, Stack, Stack0),
    Turn is J mod N,
    length(Moved, Turn),
    append(Moved, Left, Top),
    append([Left,Moved,Stack], Stack1),
    S = S0.put(stack, Stack1).
act(moveto, S0, S) :-
    S0.stack = [Y,X|Stack],
    S = S0.put(_{stack:Stack, path:[sub(open,[X-Y])|S0.path]}).
act(lineto, S0, S) :-
    S0.stack = [Y,X|Stack],
    S0.path = [sub(open,Points)|Path],
    S = S0.put(_{stack:Stack, path:[sub(open,[X-Y|Points])|Path]}).
act(rlineto, S0, S) :-
    S0.stack = [DY,DX|Stack],
    S0.path = [sub(open,[X0-Y0|Points])|Path],
    X is X0+DX,
    Y is Y0+DY,
    S = S0.put(_{stack:Stack, path:[sub(open,[X-Y,X0-Y0|Points])|Path]}).
act(re, S0, S) :-
    S0.stack = [H,W,Y,X|Stack],
    X1 is X+W,
    Y1 is Y+H,
    S = S0.put(_{ stack:Stack,
                  path:[sub(closed,[X-Y,X1-Y,X1-Y1,X-Y1,X-Y])|S0.path] }).
act(closepath, S0, S) :-
    S0.path = [sub(open,Points)|Path],
    last(Points, First),
    S = S0.put(path, [sub(closed,[First|Points])|Path]).
act(stroke, S0, S) :-
    must(S0.join =:= 1, join),
    reverse(S0.path, Subs),
    must(Subs = [_], subpaths),
    findall(path(S0.layer,S0.rgb,Width,S0.cap,S0.dash,S0.offset,Points),
            ( member(sub(_,Back), Subs),
              placed_width(S0, Width),
              placed(S0, Back, Points)
            ),
            New),
    reverse(New, Last),
    append(Last, S0.out, Out),
    S = S0.put(_{path:[], out:Out}).
act(fill, S0, S) :-
    findall(fill(S0.fill,Points),
            ( member(sub(closed,Back), S0.path), placed(S0, Back, Points) ),
            New),
    append(New, S0.fills, Fills),
    S = S0.put(_{path:[], fills:Fills}).
act(setlinewidth, S0, S) :-
    S0.stack = [W|Stack],
    S = S0.put(_{stack:Stack, width:W}).
act(setlinecap, S0, S) :-
    S0.stack = [C|Stack],
    S = S0.put(_{stack:Stack, cap:C}).
act(setlinejoin, S0, S) :-
    S0.stack = [J|Stack],
    S = S0.put(_{stack:Stack, join:J}).
act(setdash, S0, S) :-
    S0.stack = [Offset,array(Runs)|Stack],
    S = S0.put(_{stack:Stack, dash:Runs, offset:Offset}).
act(setrgbcolor, S0, S) :-
    S0.stack = [B,G,R|Stack],
    S = S0.put(_{stack:Stack, rgb:[R,G,B], fill:[R,G,B]}).
act(setfill, S0, S) :-
    S0.stack = [B,G,R|Stack],
    S = S0.put(_{stack:Stack, fill:[R,G,B]}).
act(begin_layer, S0, S) :-
    S0.stack = [Label,"/OC"|Stack],
    S0.how = how(_,_,Labels),
    must(S0.layer == none, nested_layer),
    must(memberchk(Label-Layer, Labels), no_layer(Label)),
    S = S0.put(_{stack:Stack, layer:Layer}).
act(end_layer, S0, S) :-
    must(S0.layer \== none, no_open_layer),
    S = S0.put(layer, none).

multiply([A,B,C,D,E,F], [G,H,I,J,K,L], [M,N,O,P,Q,R]) :-
    M is A*G+B*I,
    N is A*H+B*J,
    O is C*G+D*I,
    P is C*H+D*J,
    Q is E*G+F*I+K,
    R is E*H+F*J+L.

placed_width(S, Width) :-
    S.matrix = [A,B,C,D,_,_],
    Width is round(S.width*sqrt(abs(A*D-B*C))*25400/72).

placed(S, Back, Points) :-
    S.matrix = [A,B,C,D,E,F],
    reverse(Back, Own),
    H = S.height,
    findall(X-Y,
            ( member(X0-Y0, Own),
              X is round((A*X0+C*Y0+E)*25400/72),
              Y is round((H-(B*X0+D*Y0+F))*25400/72)
            ),
            Points).
