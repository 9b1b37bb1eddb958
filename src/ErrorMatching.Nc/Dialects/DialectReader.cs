using ErrorMatching.Json;

namespace ErrorMatching.Nc;

/// <summary>Applies one file to the tables of a dialect, and collects what a schema cannot say: codes that are none, and codes stated twice.</summary>
internal sealed class DialectReader(DialectDocument document, DialectTables tables)
{
    private static readonly Dictionary<string, int> Meanings = KebabNames.Of(typeof(NcMeaning));
    private static readonly Dictionary<string, int> Roles = KebabNames.Of(typeof(LetterRole));
    private static readonly Dictionary<string, int> FunctionRoles = KebabNames.Of(typeof(FunctionRole));
    private static readonly Dictionary<string, int> Syntaxes = KebabNames.Of(typeof(NcSyntax));

    public List<JsonProblem> Problems { get; } = [];

    public void Apply()
    {
        foreach (var member in document.Root.Find("settings")?.Members ?? [])
        {
            Set(member.Name, member.Value["value"]);
        }

        foreach (var (key, subjects, topic) in DialectDocument.Lists)
        {
            Apply(topic, document.List(key), subjects);
        }
    }

    private void Set(string name, JsonItem value)
    {
        switch (name)
        {
            case "syntax": tables.Syntax = (NcSyntax)Syntaxes[value.Text]; break;
            case "integersAreIncrements": tables.IntegersAreIncrements = value.Flag; break;
            case "notesNumbersWithoutPoint": tables.NotesNumbersWithoutPoint = value.Flag; break;
            case "metricDecimals": tables.MetricDecimals = (int)value.Number; break;
            case "inchDecimals": tables.InchDecimals = (int)value.Number; break;
            case "arcMismatchMm": tables.ArcMismatchMm = value.Number; break;
            case "arcMismatchOfRadius": tables.ArcMismatchOfRadius = value.Number; break;
            case "turnsLetter": tables.TurnsLetter = value.Text.Length == 0 ? (byte)0 : (byte)value.Text[0]; break;
        }
    }

    // Ranges first: a single code beats a range, wherever the two stand.
    private void Apply(DialectTopic topic, IReadOnlyList<JsonItem> entries, string key)
    {
        var singles = new List<Statement>();
        var stated = new HashSet<string>(KeywordComparer.Instance);
        var subjects = new List<SubjectRange>();
        foreach (var entry in entries)
        {
            subjects.Clear();
            if (!SubjectRange.TryRead(entry[key].Text, topic, subjects, out var bad))
            {
                Problems.Add(JsonProblem.At(entry[key], "bad-subject", $"\"{bad}\"", Expected(topic)));
                continue;
            }

            foreach (var subject in subjects)
            {
                if (subject.IsRange)
                {
                    Apply(topic, entry, subject);
                }
                else if (stated.Add(subject.Names().First()))
                {
                    singles.Add(new(entry, subject));
                }
                else
                {
                    Problems.Add(JsonProblem.At(entry[key], "stated-twice", $"{subject.Spelling} again", "each once in a file"));
                }
            }
        }

        foreach (var single in singles)
        {
            Apply(topic, single.Entry, single.Subject);
        }
    }

    private void Apply(DialectTopic topic, JsonItem entry, SubjectRange subject)
    {
        switch (topic)
        {
            case DialectTopic.Code:
                Code(subject, (NcMeaning)Meanings[entry["means"].Text], tables.FamilyNumber(entry.Find("family")?.Text ?? ""), entry.Find("feeds") is { Flag: false });
                break;
            case DialectTopic.Letter when subject.Word.Length == 1:
                tables.RoleOf[subject.Word[0] - 'A'] = (LetterRole)Roles[entry["role"].Text];
                break;
            case DialectTopic.Letter:
                foreach (var name in subject.Names())
                {
                    tables.Addresses[name] = Roles[entry["role"].Text];
                }

                break;
            case DialectTopic.Function:
                Array.Fill(tables.FunctionOf, (FunctionRole)FunctionRoles[entry["role"].Text], subject.First, subject.Last - subject.First + 1);
                break;
            case DialectTopic.Flow:
                tables.Flow.UnionWith(subject.Names());
                break;
            case DialectTopic.MachineProgram when subject is { HasNumbers: true, Word: "" }:
                tables.MachineNumbers.Add(subject);
                break;
            default:
                tables.MachineNames.UnionWith(subject.Names());
                break;
        }
    }

    private void Code(SubjectRange subject, NcMeaning meaning, int family, bool lengthsOnly)
    {
        if (subject is { HasNumbers: true, Word: "G" })
        {
            for (var tenths = subject.First; tenths <= subject.Last; tenths += subject.Step)
            {
                tables.MeaningOf[tenths] = meaning;
                tables.FamilyOf[tenths] = family;
                tables.IsForLengthsOnly[tenths] = lengthsOnly;
            }

            return;
        }

        foreach (var name in subject.Names())
        {
            tables.SetWord(name, meaning, family);
        }
    }

    private static string Expected(DialectTopic topic) => topic switch
    {
        DialectTopic.Code => "G codes up to G999.9, ranges such as G54..G59, or words in capitals, with spaces between them",
        DialectTopic.Letter => "capital letters, or longer addresses such as CR, with spaces between them",
        DialectTopic.Function => "functions such as M98, or ranges such as M100..M199, with spaces between them",
        DialectTopic.Flow => "words in capitals, with spaces between them",
        _ => "program numbers such as 9810 or 9810..9819, or names in capitals, with spaces between them",
    };
}
