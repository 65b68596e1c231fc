/* Contact sheets: however many jobs there are, each stands once, in its order,
   on pages of a thousand that name one another; what is not well says so. */
:- module(test_batch_html, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(readutil)).
:- use_module(library(sgml)).
:- use_module(library(xpath)).
:- use_module(rules('batch/batch_html')).

job(Most, Dict, head('m.pl', Folder)) :-
    working_directory(Folder, Folder),
    between(1, Most, N),
    format(string(Job), "<job> ~d", [N]),
    Dict = _{job:Job, outcome:"done", status:0, files:[], error:null}.

%   pages(Results, Counts, Pages): what a reader of HTML sees of each file.

:- meta_predicate pages(2, +, -).

pages(Results, Counts, Pages) :-
    tmp_file(sheet, Folder),
    setup_call_cleanup(
        make_directory(Folder),
        ( atom_concat(Folder, '/all.html', File),
          sheet_pages(File, Results, Counts),
          directory_files(Folder, Files0),
          exclude([F]>>memberchk(F, ['.','..']), Files0, Files),
          msort(Files, Sorted),
          maplist(page(Folder), Sorted, Pages) ),
        delete_directory_and_contents(Folder)).

page(Folder, Name, page(Name,Jobs,Links)) :-
    atomic_list_concat([Folder,/,Name], File),
    load_html(File, Document, []),
    findall(Job, xpath(Document, //figcaption(text), Job), Jobs),
    findall(Link, xpath(Document, //nav/a(@href), Link), Links).

%   A page and how many of the jobs are on it.

of_pages(0, ['all.html'-0]).
of_pages(1, ['all.html'-1]).
of_pages(999, ['all.html'-999]).
of_pages(1000, ['all.html'-1000]).
of_pages(1001, ['all.html'-1000,'all-2.html'-1]).
of_pages(2000, ['all.html'-1000,'all-2.html'-1000]).
of_pages(2001, ['all.html'-1000,'all-2.html'-1000,'all-3.html'-1]).

result(1, "done", 0, null).
result(2, "failed", 3,
       _{words:_{en:"no <such> solid",ko:"no <such> solid"}}).
result(3, "timeout", -1, null).
result(4, "killed", -1, null).
result(5, "cached", 0, null).

outcome(Dict, head('m.pl', '.')) :-
    result(N, Outcome, Status, Error),
    number_string(N, Job),
    Dict = _{job:Job, outcome:Outcome, status:Status, files:[], error:Error}.

:- begin_tests(batch_html).

test(pages, [forall(of_pages(Most, Expected)), Wrong == []]) :-
    pages(test_batch_html:job(Most), [done-Most,failed-0], Pages),
    pairs_keys(Expected, Names),
    findall(wrong(Name,What),
            ( nth1(I, Expected, Name-Count),
              (   memberchk(page(Name,Jobs,Links), Pages)
              ->  subtract(Names, [Name], Others),
                  First is (I-1)*1000+1,
                  Last is First+Count-1,
                  findall(Job, ( between(First, Last, N),
                                 format(atom(Job), '<job> ~d', [N]) ),
                          Wanted),
                  (   Jobs \== Wanted,
                      What = jobs
                  ;   Links \== Others,
                      What = links(Links)
                  )
              ;   What = missing
              ) ),
            Wrong0),
    findall(wrong(Name,extra), ( member(page(Name,_,_), Pages),
                                 \+ memberchk(Name, Names) ),
            Extra),
    append(Wrong0, Extra, Wrong).

%   What went well says nothing of it; what did not says what, and why if that
%   is known.

test(outcomes, Classes-Bold-[Text1,Text2,Text5]
               == [done,failed,timeout,killed,cached]
                  -[failed,'out of time','ended by force']
                  -['1','2failed no <such> solid','5']) :-
    tmp_file(sheet, Base),
    atom_concat(Base, '.html', File),
    setup_call_cleanup(
        sheet_pages(File, test_batch_html:outcome, [done-1,failed-1]),
        load_html(File, Document, []),
        delete_file(File)),
    findall(Class, xpath(Document, //figure(@class), Class), Classes),
    findall(Word, xpath(Document, //figcaption/b(text), Word), Bold),
    findall(Text, ( xpath(Document, //figcaption(normalize_space), Text) ),
            [Text1,Text2,_,_,Text5]).

:- end_tests(batch_html).
