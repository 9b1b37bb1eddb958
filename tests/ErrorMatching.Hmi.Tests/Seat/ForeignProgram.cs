using System.Text;
using ErrorMatching.Hmi.Platform;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Another program on the same X server, with a connection and a thread of its own: copies and pastes as a spreadsheet does.
/// It ends with the process.</summary>
internal sealed unsafe class ForeignProgram
{
    private readonly nint _display;
    private readonly nint _window;
    private readonly nint _clipboard;
    private readonly nint _utf8;
    private readonly nint _pieces;
    private readonly nint _property;

    public ForeignProgram(string display)
    {
        _display = Xlib.XOpenDisplay(display);
        Assert.NotEqual(0, _display);
        _window = Xlib.XCreateSimpleWindow(_display, Xlib.XRootWindow(_display, Xlib.XDefaultScreen(_display)), 0, 0, 1, 1, 0, 0, 0);
        _ = Xlib.XSelectInput(_display, _window, Xlib.PropertyMask);
        (_clipboard, _utf8, _pieces, _property) = (Atom("CLIPBOARD"), Atom("UTF8_STRING"), Atom("INCR"), Atom("FOREIGN"));
    }

    /// <summary>Asks for the clipboard as some target, and waits for the answer; null if it is refused.</summary>
    public Task<string?> PasteAsync(string target) => Task.Run(() =>
    {
        _ = Xlib.XConvertSelection(_display, _clipboard, Atom(target), _property, _window, 0);
        var answer = Next(Xlib.SelectionNotify);
        if (answer.AnswerProperty == 0)
        {
            return null;
        }

        _ = Xlib.XGetWindowProperty(
            _display, _window, _property, 0, 1 << 24, 1, 0, out _, out var format, out var items, out _, out var data);
        var text = format == 8
            ? Encoding.UTF8.GetString(data, (int)items)
            : string.Join(
                ' ',
                Enumerable.Range(0, (int)items)
                    .Select(i => ((nint*)data)[i])
                    .Select(a => a == Atom("UTF8_STRING") ? "UTF8_STRING" : a == Atom("TARGETS") ? "TARGETS" : "other"));
        _ = Xlib.XFree(data);
        return text;
    });

    /// <summary>Copies, and answers so many requests: whole, or in pieces of so many bytes.</summary>
    public Task CopyAsync(byte[] text, int requests, int piece = int.MaxValue)
    {
        _ = Xlib.XSetSelectionOwner(_display, _clipboard, _window, 0);
        Assert.Equal(_window, Xlib.XGetSelectionOwner(_display, _clipboard));
        return Task.Run(() =>
        {
            for (var i = 0; i < requests; i++)
            {
                Answer(Next(Xlib.SelectionRequest), text, piece);
            }
        });
    }

    private void Answer(XEvent request, byte[] text, int piece)
    {
        var isRefused = request.Target != _utf8 || text.Length == 0;
        if (!isRefused && piece < text.Length)
        {
            _ = Xlib.XSelectInput(_display, request.Requestor, Xlib.PropertyMask);
            var length = (nint)text.Length;
            _ = Xlib.XChangeProperty(_display, request.Requestor, request.Property, _pieces, 32, 0, &length, 1);
        }
        else if (!isRefused)
        {
            Put(request, text);
        }

        var answer = new XEvent
        {
            Type = Xlib.SelectionNotify,
            Window = request.Requestor,
            AnswerSelection = request.Selection,
            AnswerTarget = request.Target,
            AnswerProperty = isRefused ? 0 : request.Property
        };
        _ = Xlib.XSendEvent(_display, request.Requestor, 0, 0, ref answer);
        _ = Xlib.XFlush(_display);
        if (isRefused || piece >= text.Length)
        {
            return;
        }

        // Each piece is taken away before the next one is put there; an empty one is the end.
        for (var from = 0; ; from += piece)
        {
            XEvent change;
            do
            {
                change = Next(Xlib.PropertyNotify);
            }
            while (change.Atom != request.Property || change.PropertyState != 1);
            Put(request, text[Math.Min(from, text.Length)..Math.Min(from + piece, text.Length)]);
            if (from >= text.Length)
            {
                return;
            }
        }
    }

    private void Put(XEvent request, byte[] bytes)
    {
        fixed (byte* data = bytes)
        {
            _ = Xlib.XChangeBytes(_display, request.Requestor, request.Property, _utf8, 8, 0, data, bytes.Length);
        }

        _ = Xlib.XFlush(_display);
    }

    private XEvent Next(int type)
    {
        XEvent e;
        do
        {
            _ = Xlib.XNextEvent(_display, out e);
        }
        while (e.Type != type);
        return e;
    }

    private nint Atom(string name) => Xlib.XInternAtom(_display, name, 0);
}
