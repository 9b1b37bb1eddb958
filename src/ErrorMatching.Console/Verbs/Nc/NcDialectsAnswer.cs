using System.Globalization;
using System.Text.Json;
using ErrorMatching.Nc;

namespace ErrorMatching.Console;

/// <summary>The dialects and what they define about their controls.</summary>
internal class NcDialectsAnswer(IReadOnlyList<NcDialect> dialects) : DocumentAnswer
{
    public override string Schema => "errormatch/nc-dialects/1";

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteStartArray("dialects");
        foreach (var dialect in dialects)
        {
            json.WriteStartObject();
            json.WriteString("name", dialect.Name);
            json.WriteString("description", dialect.Description);
            json.WriteBoolean("integersAreIncrements", dialect.IntegersAreIncrements);
            json.WriteNumber("metricDecimals", dialect.MetricDecimals);
            json.WriteNumber("inchDecimals", dialect.InchDecimals);
            json.WriteNumber("arcMismatchMm", dialect.ArcMismatchMm);
            json.WriteNumber("arcMismatchOfRadius", dialect.ArcMismatchOfRadius);
            WriteFiles(json, dialect);
            json.WriteStartArray("facts");
            foreach (var fact in dialect.Facts)
            {
                json.WriteStartObject();
                json.WriteString("kind", KindOf(fact.Topic));
                json.WriteString("topic", fact.Subject);
                json.WriteString("meaning", fact.Meaning);
                json.WriteString("statement", fact.Statement);
                json.WriteString("source", fact.Source);
                json.WriteString("dialect", fact.Dialect);
                json.WriteEndObject();
            }

            json.WriteEndArray();
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    public override void WriteText(Page page)
    {
        page.Table(
            ["dialect", "least increment", "X100 is", "what it is for"],
            dialects.Select(d => (IReadOnlyList<string>)[d.Name, Increment(d), Whole(d), d.Description]));
        page.Line();
        page.Line("errormatch nc dialects NAME prints all that a dialect states of its control, and where from.");
    }

    private static string Increment(NcDialect dialect) => Increments(1, dialect);

    private static string Whole(NcDialect dialect) => dialect.IntegersAreIncrements ? Increments(100, dialect) : "100 mm";

    private static string Increments(int count, NcDialect dialect) =>
        new decimal(count, 0, 0, false, (byte)dialect.MetricDecimals).ToString("0.#########", CultureInfo.InvariantCulture) + " mm";

    private static void WriteFiles(Utf8JsonWriter json, NcDialect dialect)
    {
        json.WriteStartArray("files");
        foreach (var file in dialect.Files)
        {
            json.WriteStartObject();
            json.WriteString("file", file.File);
            json.WriteString("sha256", file.Sha256);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    private static string KindOf(DialectTopic topic) => topic switch
    {
        DialectTopic.Setting => "setting",
        DialectTopic.Code => "code",
        DialectTopic.Letter => "letter",
        DialectTopic.Function => "function",
        DialectTopic.Flow => "flow",
        DialectTopic.MachineProgram => "machine-program",
        DialectTopic.Refusal => "refusal",
        _ => "note",
    };
}
