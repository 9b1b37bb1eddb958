using System.Text.Json;

namespace ErrorMatching.Console;

/// <summary>A result, which can be written for a script and for a person.</summary>
internal abstract class Answer : Outcome
{
    /// <summary>Name and version of the JSON document, such as <c>errormatch/match/1</c>.</summary>
    public abstract string Schema { get; }

    /// <summary>Writes the members of the JSON document behind <c>schema</c>.</summary>
    public abstract void WriteJson(Utf8JsonWriter json);

    /// <summary>Writes the text for people.</summary>
    public abstract void WriteText(Page page);
}
