using System.CommandLine;
using ErrorMatching.Jobs;
using ErrorMatching.Nc;

namespace ErrorMatching.Console;

/// <summary>The option that writes what was asked beside the result, so that <c>nc prove</c> can prove it again.</summary>
internal sealed class WishOption : Option<string>
{
    /// <summary>The option.</summary>
    public WishOption()
        : base("--wish")
    {
        Description = "The file to write what was asked to, for errormatch nc prove.";
        HelpName = "FILE";
    }

    /// <summary>Writes outputs and, if it is asked for, the wish before them: all of them or none.</summary>
    /// <param name="files">The outputs; the last one is the program.</param>
    /// <param name="wish">Makes the wish.</param>
    /// <param name="arguments">What the user typed.</param>
    /// <param name="inputs">The files that were read.</param>
    /// <param name="cancellation">Looked at last before the first file appears.</param>
    public void WriteWith(
        IReadOnlyList<(string Path, ReadOnlyMemory<byte> Bytes)> files, Func<WishFile> wish, ParseResult arguments, IReadOnlyCollection<string> inputs, CancellationToken cancellation) =>
        WriteWith(files, wish, arguments, inputs, () => true, cancellation);

    /// <summary>The same, if the files may appear once they are written beside their places.</summary>
    /// <param name="files">The outputs; the last one is the program.</param>
    /// <param name="wish">Makes the wish.</param>
    /// <param name="arguments">What the user typed.</param>
    /// <param name="inputs">The files that were read.</param>
    /// <param name="mayAppear">Asked last before the first file appears.</param>
    /// <param name="cancellation">Looked at before the first file appears.</param>
    public void WriteWith(
        IReadOnlyList<(string Path, ReadOnlyMemory<byte> Bytes)> files, Func<WishFile> wish, ParseResult arguments, IReadOnlyCollection<string> inputs, Func<bool> mayAppear, CancellationToken cancellation)
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
