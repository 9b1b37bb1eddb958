using System.Text;

namespace ErrorMatching.Console;

/// <summary>A result that can be written as JSON for a script and as text for a person.</summary>
internal abstract class Answer : VerbResult
{
    /// <summary>Why the result must not be used although there is something to show; null if it may be used.</summary>
    public virtual Failure? Failure => null;

    /// <summary>A program that goes to standard output; the text for people then goes to standard error. Null if there is none.</summary>
    public virtual ReadOnlyMemory<byte>? Program => null;

    /// <summary>The result's single JSON document: UTF-8 without a byte order mark, with a final line end.</summary>
    public abstract byte[] ToJson();

    /// <summary>Writes that document, in parts if it is long.</summary>
    public virtual void WriteJson(TextWriter output) => output.Write(Encoding.UTF8.GetString(ToJson()));

    /// <summary>Writes the text for people.</summary>
    public abstract void WriteText(Page page);
}
