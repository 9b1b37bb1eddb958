using System.Runtime.InteropServices;
using Avalonia;

namespace ErrorMatching.Hmi.Platform;

/// <summary>Memory for a frame that the X server reads itself, instead of receiving the pixels through its socket.</summary>
/// <remarks>Source: MIT-SHM, The MIT Shared Memory Extension. The segment is marked for removal as soon as this process has attached it,
/// and before the server does, which Linux allows (shmat(2)): the system frees it with the last of them, however they end.</remarks>
internal sealed unsafe class X11SharedPixels : IDisposable
{
    private const int BytesPerPixel = 4;
    private static bool? _isPossible;
    private XShm.Segment* _segment;
    private bool _isRead;

    private X11SharedPixels(XShm.Segment* segment) => _segment = segment;

    /// <summary>The address of the first pixel. Rows follow each other without gaps.</summary>
    public nint Address => _segment->Address;

    /// <summary>The segment, as the server knows it.</summary>
    public XShm.Segment* Segment => _segment;

    /// <summary>Allocates memory for pixels, all zero.</summary>
    /// <returns>Null if the server does not share memory with this process: it is on another computer, it lacks the extension, libXext
    /// is missing, or the system has no segment of this size.</returns>
    public static X11SharedPixels? Create(PixelSize size)
    {
        // A server that cannot once never can: the connection and the library stay as they are.
        _isPossible ??= NativeLibraries.IsThere(XShm.Library) && XShm.XShmQueryExtension(X11Connection.Display) != 0;
        if (_isPossible == false)
        {
            return null;
        }

        var id = XShm.shmget(XShm.Private, (nuint)size.Width * (nuint)size.Height * BytesPerPixel, XShm.Create);
        if (id == -1)
        {
            return null;
        }

        var segment = (XShm.Segment*)NativeMemory.AllocZeroed((nuint)sizeof(XShm.Segment));
        (segment->Id, segment->Address, segment->IsReadOnly) = (id, XShm.shmat(id, 0, 0), 1);
        _ = XShm.shmctl(id, XShm.Remove, null);
        var isAttached = segment->Address != -1 && X11Connection.Accepts(() => _ = XShm.XShmAttach(X11Connection.Display, segment));

        // A server on another computer or in another container may have a segment of its own with the same number. If it attached that
        // one, this process is alone with its own.
        XShm.SegmentState state = default;
        var isShared = isAttached && XShm.shmctl(id, XShm.State, &state) == 0 && state.Attached == 2;
        if (isShared)
        {
            return new(segment);
        }

        _isPossible = false;
        if (isAttached)
        {
            _ = XShm.XShmDetach(X11Connection.Display, segment);
        }

        if (segment->Address != -1)
        {
            _ = XShm.shmdt(segment->Address);
        }

        NativeMemory.Free(segment);
        return null;
    }

    /// <summary>Call when the server has been asked to read the pixels.</summary>
    public void Reads() => _isRead = true;

    /// <summary>Waits until the server has read what it was asked to; call it before the pixels change.</summary>
    /// <remarks>A server executes a client's requests in order, so its answer to a later one shows that it is done. At the beginning of
    /// the next frame this is usually long so, and the answer comes at once. Events that tell when it is done would save this round
    /// trip, but they can be behind others in the queue, and would have to be waited for in the same place.</remarks>
    public void Wait()
    {
        if (_isRead)
        {
            _isRead = false;
            _ = Xlib.XSync(X11Connection.Display, 0);
            X11Connection.DrainLater();
        }
    }

    /// <summary>Frees the memory. The server still executes earlier requests: it has attached the segment by itself.</summary>
    public void Dispose()
    {
        if (_segment is not null)
        {
            _ = XShm.XShmDetach(X11Connection.Display, _segment);
            _ = Xlib.XFlush(X11Connection.Display);
            _ = XShm.shmdt(_segment->Address);
            NativeMemory.Free(_segment);
            _segment = null;
        }
    }
}
