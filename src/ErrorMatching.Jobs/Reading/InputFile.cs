using ErrorMatching.Freeform;
using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;
using Microsoft.Win32.SafeHandles;

namespace ErrorMatching.Jobs;

/// <summary>Reads inputs that the libraries take as bytes. Measurements have their own reader.</summary>
public static class InputFile
{
    /// <summary>Minimum number of bytes for a second thread to pay off.</summary>
    private const int Many = 4_000_000;

    /// <summary>The job in a file.</summary>
    /// <exception cref="InputException">The file cannot be opened. It cannot be used.</exception>
    public static MatingJob Job(string path) => MatingJob.Parse(JobBytes(path), PathText.Of(path));

    /// <summary>The free-form job in a file.</summary>
    /// <exception cref="InputException">The file cannot be opened. It cannot be used.</exception>
    public static FreeformJob Freeform(string path) => FreeformJob.Parse(JobBytes(path), PathText.Of(path));

    /// <summary>The kind of the job in a file, as the file states it; null if it states none.</summary>
    /// <exception cref="InputException">The file cannot be opened. It is not JSON.</exception>
    public static string? KindOfJob(string path)
    {
        var root = JsonInput.Read(Open(path, p => JsonInput.Load(p)), path);
        return root.Kind == JsonItemKind.Object && root.Find("kind") is { Kind: JsonItemKind.Text } kind ? kind.Text : null;
    }

    /// <summary>A built-in dialect by its name, or a shop's own dialect from a file.</summary>
    /// <param name="dialect">A name, or a file ending in <c>.json</c>.</param>
    /// <exception cref="InputException">The file cannot be opened. It cannot be used. There is no dialect of this name.</exception>
    public static NcDialect Dialect(string dialect) =>
        NcDialects.IsFile(dialect) ? Open(PathText.Of(dialect), NcDialects.Read) : NcDialects.Named(dialect);

    /// <summary>The dialect of a job's program. A dialect file is relative to the job's folder.</summary>
    /// <exception cref="InputException">The file cannot be opened. It cannot be used. There is no dialect of this name.</exception>
    public static NcDialect DialectOf(MatingJob job)
    {
        var name = job.Counterpart.Dialect;
        return Dialect(NcDialects.IsFile(name) ? job.PathOf(name) : name)
            .With(job.Counterpart.BlockSkip)
            .With(job.Counterpart.Assumed);
    }

    /// <summary>The bytes of a program.</summary>
    /// <exception cref="InputException">The file cannot be opened, or exceeds the limit for programs. There is nothing in it, or no text
    /// that a control reads.</exception>
    public static ReadOnlyMemory<byte> Program(string path) => Checked(path, Open(path, p =>
    {
        var length = new FileInfo(p).Length;
        return length <= NcProgram.MaxBytes
            ? length < Many
            ? SharedFile.ReadAllBytes(p, NcProgram.MaxBytes)
            : InHalves(p, (int)length)
            : throw new InputException(
                new Refusal(NcInputCodes.ProgramTooLarge, $"{p} has {length} bytes; at most {NcProgram.MaxBytes} are read."));
    }));

    /// <summary>The bytes of a program, if they can be one.</summary>
    /// <param name="file">Its name, for messages.</param>
    /// <param name="bytes">Its content.</param>
    /// <exception cref="InputException">There is nothing in it, or no text that a control reads.</exception>
    public static ReadOnlyMemory<byte> Checked(string file, ReadOnlyMemory<byte> bytes) =>
        ProgramContent.Problem(bytes.Span) is { } problem ? throw new InputException(problem.In(file)) : bytes;

    /// <summary>The bytes of a file.</summary>
    /// <exception cref="InputException">The file cannot be opened, or is larger than the limit.</exception>
    public static byte[] Bytes(string path, long mostBytes) => Open(path, p =>
    {
        var length = new FileInfo(p).Length;
        return length <= mostBytes
            ? SharedFile.ReadAllBytes(p, mostBytes)
            : throw new IOException($"It has {length} bytes; at most {mostBytes} are read");
    });

    /// <summary>The wish in a file.</summary>
    /// <exception cref="InputException">The file cannot be opened. It cannot be used.</exception>
    public static WishFile Wish(string path) =>
        WishFile.Read(Open(path, p => JsonInput.Load(p, JsonLimits.Default with { MaxBytes = WishFile.MaxBytes })), path);

    private static byte[] JobBytes(string path) => SharedFile.IsStream(path)
        ? throw new InputException(new Refusal(
            "job-without-folder",
            $"{path} is a pipe, and the files that a job names are looked for in the job's own folder. Name a file.",
            new() { File = path }))
        : Open(path, p => JsonInput.Load(p));

    // Reading is copying, so the two halves of a long file are read concurrently.
    private static byte[] InHalves(string path, int length)
    {
        using var file = SharedFile.OpenHandle(path, FileShare.Read | FileShare.Delete);
        var bytes = GC.AllocateUninitializedArray<byte>(length);
        var half = length / 2;
        var behind = Task.Run(() => Fill(file, bytes.AsSpan(half), half));
        Fill(file, bytes.AsSpan(0, half), 0);
        behind.GetAwaiter().GetResult();
        return bytes;
    }

    private static void Fill(SafeFileHandle file, Span<byte> bytes, long from)
    {
        while (bytes.Length > 0)
        {
            var read = RandomAccess.Read(file, bytes, from);
            if (read == 0)
            {
                throw new EndOfStreamException("it got shorter while it was read");
            }

            bytes = bytes[read..];
            from += read;
        }
    }

    /// <summary>Reads a file with a given function.</summary>
    /// <exception cref="InputException">The file cannot be opened.</exception>
    public static T Open<T>(string path, Func<string, T> read)
    {
        try
        {
            return read(path);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or NotSupportedException or ArgumentException)
        {
            throw new InputException(
                new Refusal(
                    MeasurementError.FileUnreadable,
                    $"{path} cannot be opened: {FileFault.Of(path, e)}. Name a file that this user may read.",
                    new() { File = path }),
                e);
        }
    }
}
