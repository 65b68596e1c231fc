:- module(sg_mutants_c,
          [ c_site/4                    % +Text, -Start, -End, -New
          ]).
:- use_module(mutants_rules, [other_number/2]).
:- use_module(library(dcg/basics)).
/* Where a line of C may be changed, for mutants.pl. */

c_site(Text, Start, End, New) :-
    string_codes(Text, Codes),
    phrase(tokens(0, Tokens0), Codes),
    depths(Tokens0, 0, Tokens),
    token_site(Tokens, Start, End, New).

%   A token is Kind(Start,End,Atom); space and comments are between them, the
%   ends of lines are tokens.

tokens(At, Tokens) -->
    [C],
    { code_type(C, space),
      C \== 0'\n },
    !,
    { At1 is At + 1 },
    tokens(At1, Tokens).
tokens(At, Tokens) -->
    "/*",
    !,
    string(Inside),
    "*/",
    !,
    { length(Inside, N),
      At1 is At + N + 4 },
    tokens(At1, Tokens).
tokens(At, Tokens) -->
    "//",
    !,
    line_rest(N),
    { At1 is At + 2 + N },
    tokens(At1, Tokens).
tokens(At, Tokens) -->
    "#",
    !,
    directive(0, N),
    { At1 is At + 1 + N },
    tokens(At1, Tokens).
tokens(At, [Token|Tokens]) -->
    token(Kind, Codes),
    !,
    { length(Codes, N),
      End is At + N,
      atom_codes(Atom, Codes),
      Token = token(Kind,At,End,Atom) },
    tokens(End, Tokens).
tokens(_, []) -->
    [].

line_rest(N) -->
    [C],
    { C \== 0'\n },
    !,
    line_rest(N0),
    { N is N0 + 1 }.
line_rest(0) -->
    [].

directive(N0, N) -->
    "\\\n",
    !,
    { N1 is N0 + 2 },
    directive(N1, N).
directive(N0, N) -->
    [C],
    { C \== 0'\n },
    !,
    { N1 is N0 + 1 },
    directive(N1, N).
directive(N, N) -->
    [].

token(line, [0'\n]) -->
    "\n".
token(text, Codes) -->
    [Quote],
    { memberchk(Quote, `"'`) },
    !,
    quoted(Quote, Rest),
    { Codes = [Quote|Rest] }.
token(name, [C|Cs]) -->
    [C],
    { code_type(C, csymf) },
    !,
    run(csym, Cs).
token(number, [C|Cs]) -->
    [C],
    { code_type(C, digit) },
    !,
    number_rest(Cs).
token(mark, Codes) -->
    { member(Mark, ["<<=",">>=","->","++","--","<<",">>","<=",">=","==","!=",
                    "&&","||","+=","-=","*=","/=","|=","&=","^=","%="]),
      string_codes(Mark, Codes) },
    Codes,
    !.
token(mark, [C]) -->
    [C].

quoted(Quote, [0'\\,C|Cs]) -->
    "\\",
    !,
    [C],
    quoted(Quote, Cs).
quoted(Quote, [Quote]) -->
    [Quote],
    !.
quoted(Quote, [C|Cs]) -->
    [C],
    quoted(Quote, Cs).

run(Type, [C|Cs]) -->
    [C],
    { code_type(C, Type) },
    !,
    run(Type, Cs).
run(_, []) -->
    [].

number_rest([E,S|Cs]) -->
    [E,S],
    { memberchk(E, `eEpP`),
      memberchk(S, `+-`) },
    !,
    number_rest(Cs).
number_rest([C|Cs]) -->
    [C],
    { ( code_type(C, csym) ; C == 0'. ) },
    !,
    number_rest(Cs).
number_rest([]) -->
    [].

%   depths(+Tokens0, +Depth, -Tokens): each with the braces around it.

depths([], _, []).
depths([token(Kind,F,T,Atom)|Tokens0], D0, [token(Kind,F,T,Atom,D0)|Tokens]) :-
    (   Atom == '{'
    ->  D is D0 + 1
    ;   Atom == '}'
    ->  D is D0 - 1
    ;   D = D0
    ),
    depths(Tokens0, D, Tokens).

%   here(+Tokens, -Back, -Token, -After) is nondet.
%
%   Token stands between Back, from right to left, and After.

here(Tokens, Back, Token, After) :-
    here(Tokens, [], Back, Token, After).

here([Token|After], Back, Back, Token, After).
here([Token0|Tokens], Back0, Back, Token, After) :-
    here(Tokens, [Token0|Back0], Back, Token, After).

token_site(Tokens, Start, End, New) :-
    here(Tokens, Back, token(Kind,F,T,Atom,D), After),
    token_site(Kind, Atom, F, T, D, Back, After, Start, End, New).

token_site(mark, Mark, F, T, D, Back, _, F, T, New) :-
    D > 0,
    binary(Back),
    c_neighbours(Mark, News),
    member(New, News).
token_site(mark, '++', F, T, D, _, _, F, T, "--") :-
    D > 0.
token_site(mark, '--', F, T, D, _, _, F, T, "++") :-
    D > 0.
token_site(mark, !, F, T, _, _, [token(Kind,_,_,_,_)|_], F, T, " ") :-
    Kind \== line.
token_site(name, Name, F, T, D, _, _, F, T, New) :-
    D > 0,
    memberchk(Name-New, [true-"false", false-"true", continue-"", break-"",
                         fmin-"fmax", fmax-"fmin"]).
token_site(number, Atom, F, T, _, Back, After, F, T, New) :-
    \+ declared_size(Back, After),
    c_number(Atom, New).
token_site(name, if, _, _, _, _, [token(_,Start,_,'(',_)|After], Start, End,
           negated) :-
    closing(After, 1, End).
token_site(mark, Mark, _, T, _, Back, _, Start, T, "") :- % A && dropped
    memberchk(Mark, [&&,'||']),
    operand_before(Back, 0, none, Start),
    Start \== none.
token_site(mark, Mark, F, T, _, _, After, F, End, "") :-  % && B dropped
    memberchk(Mark, [&&,'||']),
    operand_after(After, 0, T, End),
    End > T.
token_site(mark, Left, _, _, _, _, After, Start, End, "") :- % a statement
    memberchk(Left, [;,'{','}']),
    skip_lines(After, [token(name,Start,_,Name,D),token(mark,_,_,Next,_)
                       |Rest]),
    D > 0,
    \+ memberchk(Name, [if,for,while,return,switch,else,do,case,sizeof]),
    memberchk(Next, ['(',=,->,'.','[',++,--,+=,-=,'|=',&=,*=]),
    memberchk(token(mark,_,End,;,_), Rest).

skip_lines([token(line,_,_,_,_)|Tokens0], Tokens) :-
    !,
    skip_lines(Tokens0, Tokens).
skip_lines(Tokens, Tokens).

%   A sign has two operands if one stands before it.

binary([token(Kind,_,_,Last,_)|Back]) :-
    (   memberchk(Kind, [name,number])
    ->  \+ memberchk(Last, [return,case,sizeof])
    ;   memberchk(Last, [')',']'])
    ->  true
    ;   Kind == line,
        binary(Back)
    ).

c_neighbours(<, ["<=", ">"]).
c_neighbours(<=, ["<", ">="]).
c_neighbours(>, [">=", "<"]).
c_neighbours(>=, [">", "<="]).
c_neighbours(==, ["!="]).
c_neighbours('!=', ["=="]).
c_neighbours(&&, ["||"]).
c_neighbours('||', ["&&"]).
c_neighbours(+, ["-"]).
c_neighbours(-, ["+"]).
c_neighbours(/, ["*"]).
c_neighbours('%', ["/"]).
c_neighbours('+=', ["-=", "="]).
c_neighbours('-=', ["+=", "="]).
c_neighbours('|=', ["=", "&="]).
c_neighbours('&=', ["=", "|="]).
c_neighbours('<<', [">>"]).
c_neighbours('>>', ["<<"]).

declared_size([token(_,_,_,'[',_)|Back], [token(_,_,_,']',_)|_]) :-
    first_of_line(Back, First),
    memberchk(First, [double,int,char,const,static,size_t,bool,unsigned,
                      uint8_t,uint16_t,uint32_t,uint64_t,int64_t,mpz_t]).

first_of_line([token(_,_,_,First,_),token(line,_,_,_,_)|_], First) :-
    !.
first_of_line([_|Back], First) :-
    first_of_line(Back, First).

c_number(Atom, New) :-
    catch(atom_number(Atom, N), _, fail),
    other_number(N, New).
c_number(Atom, New) :-
    atom_concat(Digits, u, Atom),
    atom_number(Digits, N),
    other_number(N, New0),
    atom_concat(New0, u, New).

%   closing(+Tokens, +Open, -End): where the parenthesis closes, on this line.

closing([token(Kind,_,T,Atom,_)|Tokens], Open0, End) :-
    Kind \== line,
    deeper(Atom, Open0, Open),
    (   Open =:= 0
    ->  End = T
    ;   closing(Tokens, Open, End)
    ).

deeper(Atom, Depth0, Depth) :-
    (   memberchk(Atom, ['(','['])
    ->  Depth is Depth0 + 1
    ;   memberchk(Atom, [')',']'])
    ->  Depth is Depth0 - 1
    ;   Depth = Depth0
    ).

%   What stands before a && as far as the parenthesis or && before it, and
%   what stands after one: on its line.

operand_before([token(Kind,F,_,Atom,_)|Back], Depth0, Start0, Start) :-
    deeper(Atom, Depth0, Depth),
    (   Kind == line
    ->  Depth =:= 0,
        Start = Start0
    ;   Depth0 =:= 0,
        memberchk(Atom, ['(','['])
    ->  Start = Start0
    ;   Depth =:= 0,
        memberchk(Atom, [&&,'||',?,:,=,return,;,',','{','}'])
    ->  Start = Start0
    ;   operand_before(Back, Depth, F, Start)
    ).

operand_after([token(Kind,_,T,Atom,_)|After], Depth0, End0, End) :-
    deeper(Atom, Depth0, Depth),
    (   Kind == line
    ->  Depth0 =:= 0,
        End = End0
    ;   Depth < 0
    ->  End = End0
    ;   Depth =:= 0,
        memberchk(Atom, [&&,'||',?,:,;,',','{','}'])
    ->  End = End0
    ;   operand_after(After, Depth, T, End)
    ).
