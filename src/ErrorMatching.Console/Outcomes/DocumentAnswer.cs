using System.Text.Json;

namespace ErrorMatching.Console;

/// <summary>An answer whose JSON document the console itself composes.</summary>
internal abstract class DocumentAnswer : Answer
{
    /// <summary>Name and version of the JSON document, such as <c>errormatch/match/1</c>.</summary>
    public abstract string Schema { get; }

    /// <summary>Writes the members of the JSON document that follow <c>schema</c>.</summary>
    public abstract void WriteJson(Utf8JsonWriter json);

    public sealed override byte[] ToJson() => OutcomeWriter.Json(Schema, WriteJson);
}
