using System.Text.Json;
using ErrorMatching.Nc;

namespace ErrorMatching.Console;

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
