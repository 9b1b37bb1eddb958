using System.CommandLine;
using System.Runtime.CompilerServices;
using System.Text.Json;
using ErrorMatching.Cell;
using ErrorMatching.Freeform;
using ErrorMatching.Mating;

namespace ErrorMatching.Console;

/// <summary><c>errormatch job schema</c>.</summary>
internal sealed class JobSchema : Verb
{
    private readonly Argument<string> _kind = JobKind.Argument();

    public JobSchema()
        : base("schema", "Prints the JSON Schema of jobs, or of a cell: every key with its meaning.", "errormatch job schema mating") =>
            Arguments.Add(_kind);

    public override VerbResult Run(ParseResult arguments, CancellationToken cancellation) =>
        new JobSchemaAnswer(SchemaOf(arguments.GetRequiredValue(_kind)));

    private static string SchemaOf(string kind) => kind switch
    {
        JobKind.Freeform => FreeformTemplate.Schema,
        JobKind.Cell => CellSchema(),
        _ => JobTemplate.Schema,
    };

    // A method of its own, so that a job does not load the cell.
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static string CellSchema() => CellTemplate.Schema;
}

/// <summary>The JSON Schema of a kind of job. As a document of the console it has an additional key for that, which validators
/// ignore.</summary>
internal sealed class JobSchemaAnswer(string text) : DocumentAnswer
{
    public override string Schema => "errormatch/job-schema/1";

    public override void WriteJson(Utf8JsonWriter json)
    {
        using var schema = JsonDocument.Parse(text);
        foreach (var member in schema.RootElement.EnumerateObject())
        {
            member.WriteTo(json);
        }
    }

    public override void WriteText(Page page) => page.Line(text.TrimEnd('\n'));
}
