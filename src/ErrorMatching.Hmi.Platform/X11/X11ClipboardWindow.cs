using System.Text;

namespace ErrorMatching.Hmi.Platform;

/// <summary>A window that is never shown; it offers text to other programs and receives text from them.</summary>
/// <remarks>Source: Inter-Client Communication Conventions Manual 2.0, chapter 2: selections, the targets TARGETS, UTF8_STRING and STRING,
/// and INCR for data in pieces.</remarks>
internal sealed class X11ClipboardWindow
{
    /// <summary>Text above this size is not meant to be pasted.</summary>
    public const int MostBytes = 64 << 20;

    private const nint Atoms = 4, Latin1 = 31;
    private const int NewValue = 0, Slack = 256;
    private readonly nint _window;
    private readonly nint _clipboard = Atom("CLIPBOARD");
    private readonly nint _targets = Atom("TARGETS");
    private readonly nint _utf8 = Atom("UTF8_STRING");
    private readonly nint _plain = Atom("text/plain;charset=utf-8");
    private readonly nint _pieces = Atom("INCR");
    private readonly nint _property = Atom("ERRORMATCHING_CLIPBOARD");
    private byte[]? _offered;
    private Action? _lost;
    private TaskCompletionSource<nint>? _answered;
    private TaskCompletionSource? _changed;

    public X11ClipboardWindow()
    {
        X11Connection.Open();
        _window = Xlib.XCreateSimpleWindow(Display, Xlib.XRootWindow(Display, Xlib.XDefaultScreen(Display)), 0, 0, 1, 1, 0, 0, 0);
        _ = Xlib.XSelectInput(Display, _window, Xlib.PropertyMask);
        X11Connection.Add(_window, OnEvent);
    }

    private static nint Display => X11Connection.Display;

    /// <summary>True until another program copies.</summary>
    public bool IsOwner => Xlib.XGetSelectionOwner(Display, _clipboard) == _window;

    /// <summary>Offers text to other programs.</summary>
    /// <param name="utf8">The text; null to offer nothing.</param>
    /// <param name="lost">Called when another program offers something; immediately, if one just has.</param>
    public void Offer(byte[]? utf8, Action lost)
    {
        (_offered, _lost) = (utf8, lost);
        if (utf8 is not null || IsOwner)
        {
            _ = Xlib.XSetSelectionOwner(Display, _clipboard, utf8 is null ? 0 : _window, 0);

            // Checked, as the conventions require (2.1): the reply confirms that the server has accepted it. Before that, another program
            // might still have asked the previous owner.
            if (utf8 is not null && !IsOwner)
            {
                (_offered, _lost) = (null, null);
                lost();
            }
        }

        X11Connection.DrainLater();
    }

    /// <summary>The text that another program offers, in UTF-8; null if there is none, or if the program does not respond.</summary>
    /// <param name="patience">How long to wait for each response.</param>
    public async Task<byte[]?> ReadAsync(TimeSpan patience)
    {
        foreach (var target in new[] { _utf8, Latin1 })
        {
            _answered = new(TaskCreationOptions.RunContinuationsAsynchronously);
            _ = Xlib.XConvertSelection(Display, _clipboard, target, _property, _window, 0);
            X11Connection.DrainLater();
            if (!await InTime(_answered.Task, patience))
            {
                return null;
            }

            if (await _answered.Task != 0 && await TakeAsync(patience) is { } bytes)
            {
                return target == _utf8 ? bytes : Encoding.UTF8.GetBytes(Encoding.Latin1.GetString(bytes));
            }
        }

        return null;
    }

    private static nint Atom(string name)
    {
        X11Connection.Open();
        return Xlib.XInternAtom(X11Connection.Display, name, 0);
    }

    private static async Task<bool> InTime(Task task, TimeSpan patience) => await Task.WhenAny(task, Task.Delay(patience)) == task;

    // Each piece is stored where the previous one was deleted; an empty piece is the end.
    private async Task<byte[]?> TakeAsync(TimeSpan patience)
    {
        _changed = new(TaskCreationOptions.RunContinuationsAsynchronously);
        var (type, piece) = Take();
        if (type != _pieces)
        {
            return piece;
        }

        using var whole = new MemoryStream();
        do
        {
            if (!await InTime(_changed.Task, patience))
            {
                return null;
            }

            _changed = new(TaskCreationOptions.RunContinuationsAsynchronously);
            (_, piece) = Take();
            if (piece is null || whole.Length + piece.Length > MostBytes)
            {
                return null;
            }

            whole.Write(piece);
        }
        while (piece.Length > 0);
        return whole.ToArray();
    }

    private unsafe (nint Type, byte[]? Bytes) Take()
    {
        var status = Xlib.XGetWindowProperty(
            Display, _window, _property, 0, MostBytes / 4, 1, 0, out var type, out var format, out var items, out var left, out var data);
        X11Connection.DrainLater();
        try
        {
            // A 32-bit length precedes pieces; text has 8 bits per character.
            return status != 0 || left > 0
                ? (0, null)
                : (type, format == 8 ? new ReadOnlySpan<byte>(data, (int)items).ToArray() : type == _pieces ? [] : null);
        }
        finally
        {
            if (data is not null)
            {
                _ = Xlib.XFree(data);
            }
        }
    }

    private void OnEvent(XEvent e)
    {
        switch (e.Type)
        {
            case Xlib.SelectionRequest:
                Answer(e);
                break;
            case Xlib.SelectionNotify:
                _answered?.TrySetResult(e.AnswerProperty);
                break;
            case Xlib.PropertyNotify when e.Atom == _property && e.PropertyState == NewValue:
                _changed?.TrySetResult();
                break;
            case Xlib.SelectionClear:
                _offered = null;
                _lost?.Invoke();
                break;
        }
    }

    private void Answer(XEvent request)
    {
        // Old programs name no property: then the target's name is used.
        var property = request.Property == 0 ? request.Target : request.Property;
        var answer = new XEvent
        {
            Type = Xlib.SelectionNotify,
            Window = request.Requestor,
            AnswerSelection = request.Selection,
            AnswerTarget = request.Target,
            AnswerProperty = Put(request.Requestor, property, request.Target) ? property : 0,
            AnswerTime = request.Time,
        };
        _ = Xlib.XSendEvent(Display, request.Requestor, 0, 0, ref answer);
        X11Connection.DrainLater();
    }

    private unsafe bool Put(nint requestor, nint property, nint target)
    {
        if (_offered is not { } text)
        {
            return false;
        }

        if (target == _targets)
        {
            nint[] all = [_targets, _utf8, _plain, .. Ascii.IsValid(text) ? [Latin1] : Array.Empty<nint>()];
            fixed (nint* data = all)
            {
                _ = Xlib.XChangeProperty(Display, requestor, property, Atoms, 32, 0, data, all.Length);
            }

            return true;
        }

        // The server accepts this much at once. More would need pieces, and users do not copy that much out of a station.
        var most = 4 * Math.Max(Xlib.XMaxRequestSize(Display), Xlib.XExtendedMaxRequestSize(Display));
        if (text.Length > most - Slack || (target != _utf8 && target != _plain && !(target == Latin1 && Ascii.IsValid(text))))
        {
            return false;
        }

        fixed (byte* data = text)
        {
            _ = Xlib.XChangeBytes(Display, requestor, property, target, 8, 0, data, text.Length);
        }

        return true;
    }
}
