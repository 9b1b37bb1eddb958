using System.CommandLine;
using System.Text.Json;
using ErrorMatching.Jobs;
using ErrorMatching.Nc;

namespace ErrorMatching.Console;

/// <summary><c>errormatch nc dialects</c>.</summary>
internal sealed class NcDialectsVerb : Verb
{
    private readonly Argument<string> _dialect = new("NAME|FILE.json")
    {
        Description = "One dialect, whose whole table is printed. Without it, all are listed.",
        Arity = ArgumentArity.ZeroOrOne
    };
    private readonly Option<bool> _schema = new("--schema")
    {
        Description = "Prints the JSON Schema of dialect files instead.",
        Arity = ArgumentArity.Zero
    };

    public NcDialectsVerb()
        : base("dialects", "Lists the controls that are known, or all that is stated of one, with sources.", "errormatch nc dialects fanuc")
    {
        _dialect.CompletionSources.Add([.. NcDialects.Names]);
        Arguments.Add(_dialect);
        Options.Add(_schema);
        Validators.Add(result =>
        {
            if (result.GetResult(_schema) is not null && result.GetResult(_dialect) is { Tokens.Count: > 0 })
            {
                result.AddError("--schema takes no dialect.");
            }
        });
    }

    public override VerbResult Run(ParseResult arguments, CancellationToken cancellation) =>
        arguments.GetValue(_schema) ? new NcDialectSchemaAnswer()
        : arguments.GetValue(_dialect) is { } dialect ? new NcDialectAnswer(InputFile.Dialect(dialect))
        : new NcDialectsAnswer(NcDialects.All);
}

/// <summary>The JSON Schema of dialect files. As a document of the console it has an additional key for that, which validators
/// ignore.</summary>
internal sealed class NcDialectSchemaAnswer : DocumentAnswer
{
    public override string Schema => "errormatch/nc-dialect-schema/1";

    public override void WriteJson(Utf8JsonWriter json)
    {
        using var schema = JsonDocument.Parse(NcDialects.Schema);
        foreach (var member in schema.RootElement.EnumerateObject())
        {
            member.WriteTo(json);
        }
    }

    public override void WriteText(Page page) => page.Line(NcDialects.Schema.TrimEnd('\n'));
}
