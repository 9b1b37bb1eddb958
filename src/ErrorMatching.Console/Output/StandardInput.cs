using ErrorMatching.Jobs;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Console;

/// <summary>Standard input as the file that <c>-</c> names on a command line. It can be read once.</summary>
/// <param name="open">Opens it; called only if it is named.</param>
internal sealed class StandardInput(Func<Stream> open)
{
    /// <summary>The word that stands for it, and for standard output behind <c>--out</c>.</summary>
    public const string Dash = "-";

    /// <summary>Its name in messages and results.</summary>
    public const string Name = "standard input";

    private bool _isRead;

    /// <summary>A standard input without content.</summary>
    public static StandardInput Empty => new(() => Stream.Null);

    /// <summary>The name in messages and results of a file that the user named.</summary>
    public static string NameOf(string file) => file == Dash ? Name : file;

    /// <summary>A file that the user named, with its content if that comes from standard input.</summary>
    /// <param name="file">What the user typed.</param>
    /// <param name="mostBytes">Size limit of standard input; a file has that of its reader.</param>
    /// <param name="tooLarge">The code of the refusal beyond it.</param>
    /// <exception cref="InputException">Standard input cannot be read, or has more bytes.</exception>
    public GivenFile File(string file, int mostBytes, string tooLarge) =>
        file == Dash ? new(Name, Read(mostBytes, tooLarge)) : new(file);

    /// <summary>All bytes of standard input.</summary>
    /// <param name="mostBytes">Size limit.</param>
    /// <param name="tooLarge">The code of the refusal beyond it.</param>
    /// <exception cref="InputException">It cannot be read, or has more bytes.</exception>
    public ReadOnlyMemory<byte> Read(int mostBytes, string tooLarge)
    {
        // The command line is refused if it names standard input twice.
        if (_isRead)
        {
            throw new InvalidOperationException("Standard input was read already.");
        }

        _isRead = true;
        try
        {
            using var stream = open();
            using var content = new MemoryStream();
            var buffer = new byte[1 << 16];
            for (var read = stream.Read(buffer); read > 0; read = stream.Read(buffer))
            {
                if (content.Length + read > mostBytes)
                {
                    throw new InputException(
                        new Refusal(tooLarge, $"{Name} has more than {mostBytes} bytes, which is the limit.", new() { File = Name }));
                }

                content.Write(buffer, 0, read);
            }

            return content.GetBuffer().AsMemory(0, (int)content.Length);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or NotSupportedException)
        {
            throw new InputException(
                new Refusal(
                    MeasurementError.FileUnreadable,
                    $"{Name} cannot be read: {e.Message.TrimEnd('.')}. Name a file, or pass the content through a pipe.",
                    new() { File = Name }),
                e);
        }
    }
}
