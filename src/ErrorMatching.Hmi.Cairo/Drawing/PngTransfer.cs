using System.Runtime.InteropServices;

namespace ErrorMatching.Hmi.Cairo;

/// <summary>A stream that cairo reads a picture from or writes one to. No exception may pass through native code: it is kept until cairo has returned.</summary>
internal sealed class PngTransfer : IDisposable
{
    private readonly Stream _stream;
    private GCHandle _handle;

    /// <summary>A transfer, for as long as it is not disposed.</summary>
    public PngTransfer(Stream stream)
    {
        _stream = stream;
        _handle = GCHandle.Alloc(this);
    }

    /// <summary>What cairo hands back to its callbacks.</summary>
    public nint Closure => GCHandle.ToIntPtr(_handle);

    /// <summary>What the stream threw; null if nothing.</summary>
    public Exception? Failure { get; private set; }

    /// <summary>The transfer of a callback.</summary>
    public static PngTransfer Of(nint closure) => (PngTransfer)GCHandle.FromIntPtr(closure).Target!;

    /// <summary>Fills bytes from the stream.</summary>
    /// <returns>False if it cannot.</returns>
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
    /// <returns>False if it cannot.</returns>
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

    /// <inheritdoc/>
    public void Dispose() => _handle.Free();
}
