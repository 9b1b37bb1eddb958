using System.CommandLine;
using ErrorMatching.Jobs;
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

    /// <summary>Writes the outputs, preceded by the wish file if requested: all of them or none.</summary>
    /// <param name="files">The outputs; the last one is the program.</param>
    /// <param name="wish">Creates the wish file's content.</param>
    /// <param name="arguments">The user's arguments.</param>
    /// <param name="inputs">The files that were read.</param>
    /// <param name="cancellation">Last checked before the first file appears.</param>
    public void WriteWith(
        IReadOnlyList<(string Path, ReadOnlyMemory<byte> Bytes)> files,
        Func<WishFile> wish,
        ParseResult arguments,
        IReadOnlyCollection<string> inputs,
        CancellationToken cancellation) =>
        WriteWith(files, wish, arguments, inputs, () => true, cancellation);

    /// <summary>The same, with a final check once the files are written next to their targets.</summary>
    /// <param name="files">The outputs; the last one is the program.</param>
    /// <param name="wish">Creates the wish file's content.</param>
    /// <param name="arguments">The user's arguments.</param>
    /// <param name="inputs">The files that were read.</param>
    /// <param name="mayAppear">Called last, before the first file appears.</param>
    /// <param name="cancellation">Checked before the first file appears.</param>
    public void WriteWith(
        IReadOnlyList<(string Path, ReadOnlyMemory<byte> Bytes)> files,
        Func<WishFile> wish,
        ParseResult arguments,
        IReadOnlyCollection<string> inputs,
        Func<bool> mayAppear,
        CancellationToken cancellation)
    {
        if (arguments.GetValue(this) is { } file)
        {
            using var stream = new MemoryStream();
            wish().WriteTo(stream);
            files = [(file, stream.GetBuffer().AsMemory(0, (int)stream.Length)), .. files];
        }

        if (files.Count > 0)
        {
            OutputFile.WriteAll(files, inputs, mayAppear, cancellation);
        }
    }
}
