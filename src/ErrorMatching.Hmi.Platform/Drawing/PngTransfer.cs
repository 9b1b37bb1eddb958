using System.Runtime.InteropServices;

namespace ErrorMatching.Hmi.Platform;

/// <summary>A stream that Cairo reads a picture from or writes one to. Exceptions must not pass through native code: they are kept until
/// Cairo has returned.</summary>
internal sealed class PngTransfer : IDisposable
{
    private readonly Stream _stream;
    private GCHandle _handle;

    /// <summary>Starts a transfer, which ends when disposed of.</summary>
    public PngTransfer(Stream stream)
    {
        _stream = stream;
        _handle = GCHandle.Alloc(this);
    }

    /// <summary>The argument that Cairo passes to its callbacks.</summary>
    public nint Closure => GCHandle.ToIntPtr(_handle);

    /// <summary>The stream's exception; null for none.</summary>
    public Exception? Failure { get; private set; }

    /// <summary>The transfer for a callback's argument.</summary>
    public static PngTransfer Of(nint closure) => (PngTransfer)GCHandle.FromIntPtr(closure).Target!;

    /// <summary>Fills bytes from the stream.</summary>
    /// <returns>False if that fails.</returns>
    public bool Read(Span<byte> bytes)
    {
        try
        {
            _stream.ReadExactly(bytes);
            return true;
        }
        catch (Exception e)
        {
            Failure = e;
            return false;
        }
    }

    /// <summary>Writes bytes to the stream.</summary>
    /// <returns>False if that fails.</returns>
    public bool Write(ReadOnlySpan<byte> bytes)
    {
        try
        {
            _stream.Write(bytes);
            return true;
        }
        catch (Exception e)
        {
            Failure = e;
            return false;
        }
    }

    public void Dispose() => _handle.Free();
}
