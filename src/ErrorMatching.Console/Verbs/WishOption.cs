using System.CommandLine;
using ErrorMatching.Nc;

namespace ErrorMatching.Console;

/// <summary>The option that saves the request next to the result, so that <c>nc prove</c> can check the result again.</summary>
internal sealed class WishOption : Option<string>
{
    public WishOption()
        : base("--wish")
    {
        Description = "The file to write what was asked to, for errormatch nc prove.";
        HelpName = "FILE";
    }

    /// <summary>The outputs, preceded by the wish file if requested.</summary>
    /// <param name="files">The outputs; the last one is the program.</param>
    /// <param name="wish">Creates the wish file's content.</param>
    /// <param name="arguments">The user's arguments.</param>
    public IReadOnlyList<(string Path, ReadOnlyMemory<byte> Bytes)> Before(
        IReadOnlyList<(string Path, ReadOnlyMemory<byte> Bytes)> files, Func<WishFile> wish, ParseResult arguments)
    {
        if (arguments.GetValue(this) is not { } file)
        {
            return files;
        }

        using var stream = new MemoryStream();
        wish().WriteTo(stream);
        return [(file, stream.GetBuffer().AsMemory(0, (int)stream.Length)), .. files];
    }
}
