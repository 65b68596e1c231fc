:- encoding(utf8).
:- module(sg_model_tree,
          [ text_tree/2                 % +Text, -Tree
          ]).
:- use_module('../message/term_word_ko', [term_word_ko/2]).
:- use_module('../primitive/primitive',
              [primitive/1, primitive_numbers/3]).
:- use_module(library(lists), [member/2]).
/** <module> The segments and parameters of a model's text, as a form shows
them.

What stands in the text, not what the store made of it: a number that a form
changes is one of the text (text_edit.pl).
*/

%!  text_tree(+Text, -Tree:dict) is det.
%
%   Tree has the keys
%
%     - segments: a list of _{segment:S, kind:Kind, term:Term}, in the order of
%       Text. A Term is a number, a text, a list of Terms, or
%       _{name:Name, args:Terms}
%     - params: a list of _{param:Name, value:Term, about:About}; About has the
%       numbers min, max, step and the texts en, ko that the text gives
%     - forms: of the primitives in it, _{cylinder:_{radius:Types, ...}, ...}:
%       the types (primitive_argument.pl) of the numbers of each argument
%     - words: of the words in terms, what they are called in Korean,
%       _{cylinder:'원기둥', ...}
%     - questions: a list of _{name:Name, goal:Goal}, texts
%
%   Text is that of a model, which has been loaded.

text_tree(Text, _{ segments:Segments, params:Params, forms:Forms,
                   words:Words, questions:Questions }) :-
    setup_call_cleanup(
        open_string(Text, In),
        facts(In, Facts),
        close(In)),
    findall(_{segment:S, kind:Kind, term:Json},
            ( member(segment(S, Kind, Term), Facts), term_json(Term, Json) ),
            Segments),
    findall(_{param:Name, value:Json, about:About},
            ( member(param(Name, Term), Facts), term_json(Term, Json),
              about(Facts, Name, About) ),
            Params),
    findall(Name-Form,
            ( primitive(Name), once(( member(segment(_, _, Term), Facts),
                                      has_name(Term, Name) )),
              form(Name, Form) ),
            Pairs),
    dict_pairs(Forms, _, Pairs),
    findall(Word-Korean,
            ( term_word_ko(Word, Korean), once(( member(segment(_, _, Term),
                                                        Facts),
                                                 has_name(Term, Word) )) ),
            Koreans),
    dict_pairs(Words, _, Koreans),
    findall(_{name:Called, goal:Goal},
            ( member(question(Called0, Goal0), Facts),
              text_to_string(Called0, Called), text_to_string(Goal0, Goal) ),
            Questions).

facts(In, Facts) :-
    read_term(In, Fact, [ module(sg_model_syntax), cycles(false),
                          dotlists(false), var_prefix(false) ]),
    (   Fact == end_of_file
    ->  Facts = []
    ;   Facts = [Fact|Facts1],
        facts(In, Facts1)
    ).

about(Facts, Name, About) :-
    findall(Key-Value,
            ( member(param_about(Name, Abouts), Facts),
              member(Of, Abouts),
              (   Of = text(Key, Value)
              ->  true
              ;   Of =.. [Key,Value],
                  memberchk(Key, [min,max,step]),
                  number(Value)
              ) ),
            Pairs),
    dict_pairs(About, _, Pairs).

term_json(Term, Json) :-
    (   number(Term)
    ->  Json = Term
    ;   is_list(Term)
    ->  findall(Item, ( member(Inner, Term), term_json(Inner, Item) ), Json)
    ;   compound(Term)
    ->  compound_name_arguments(Term, Name, Arguments),
        findall(Item, ( member(Inner, Arguments), term_json(Inner, Item) ),
                Items),
        Json = _{name:Name, args:Items}
    ;   format(string(Json), "~w", [Term])
    ).

has_name(Term, Name) :-
    compound(Term),
    (   compound_name_arity(Term, Name, _)
    ->  true
    ;   compound_name_arguments(Term, _, Arguments),
        member(Argument, Arguments),
        has_name(Argument, Name)
    ).

form(Name, Form) :-
    findall(Argument-Types, primitive_numbers(Name, Argument, Types), Pairs),
    dict_pairs(Form, _, Pairs).
