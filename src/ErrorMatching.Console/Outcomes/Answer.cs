using System.Text;

namespace ErrorMatching.Console;

/// <summary>A result, which can be written for a script and for a person.</summary>
internal abstract class Answer : Outcome
{
    /// <summary>Why the result must not be used although there is something to show; null where it may.</summary>
    public virtual Failure? Failure => null;

    /// <summary>The one JSON document of the result: UTF-8 without a byte order mark, with a line end behind it.</summary>
    public abstract byte[] ToJson();

    /// <summary>Writes that document, in parts where it is long.</summary>
    public virtual void WriteJson(TextWriter output) => output.Write(Encoding.UTF8.GetString(ToJson()));

    /// <summary>Writes the text for people.</summary>
    public abstract void WriteText(Page page);
}
