using Avalonia;
using Avalonia.Input.TextInput;
using Avalonia.Threading;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The system's input method in one window (IMM32): text is composed in the field itself, and candidates are beside its
/// caret. A finger on a field brings the touch keyboard, which goes when no field has the focus any more.</summary>
/// <param name="window">The window.</param>
internal sealed unsafe class Win32InputMethod(Win32Window window) : ITextInputMethodImpl
{
    // IACE_DEFAULT: the system's own context; and the flag by which its own window for what is composed is shown.
    private const uint DefaultContext = 0x10;
    private const long ShowsComposition = 0x80000000;
    private TextInputMethodClient? _client;
    private Rect _caret;
    private Win32TouchKeyboard? _keyboard;
    private bool _isKeyboardSought;

    /// <summary>Keys outside of text fields are commands, or a scanner's code: they must not begin a composition.</summary>
    public void TurnOff() => _ = Imm32.ImmAssociateContextEx(window.Window, 0, 0);

    public void SetClient(TextInputMethodClient? client)
    {
        if (!ReferenceEquals(_client, client))
        {
            Reset();
            _client?.InputPaneActivationRequested -= OnTappedAgain;
            _client = client;
            if (client is null)
            {
                TurnOff();

                // Between two fields, no field has the focus for a moment.
                Dispatcher.UIThread.Post(PutAwayKeyboard, DispatcherPriority.Background);
            }
            else
            {
                client.InputPaneActivationRequested += OnTappedAgain;
                _ = Imm32.ImmAssociateContextEx(window.Window, 0, DefaultContext);
                BringKeyboard();
            }
        }
    }

    /// <summary>Ends its use, before the window goes.</summary>
    public void Close()
    {
        SetClient(null);
        _keyboard?.Leave();
        (_keyboard, _isKeyboardSought) = (null, true);
    }

    public void SetCursorRect(Rect rect)
    {
        _caret = rect;
        Place();
    }

    public void SetOptions(TextInputOptions options)
    {
        // The system's input method has no kinds of fields.
    }

    public void Reset() => With(context =>
    {
        _ = Imm32.ImmNotify(context, Imm32.EndsComposition, Imm32.Cancel, 0);
        _client?.SetPreeditText(null);
    });

    /// <summary>Handles a message.</summary>
    /// <param name="message">The message; for one that is changed, the system gets the changed one.</param>
    /// <param name="w">Its first parameter.</param>
    /// <param name="l">Its second parameter.</param>
    /// <returns>The answer; null for the system's own.</returns>
    public nint? On(uint message, nint w, nint l)
    {
        var isInPlace = _client?.SupportsPreedit == true;
        switch (message)
        {
            case Win32Message.InputContext when isInPlace:
                return User32.Default(window.Window, message, w, (nint)(l & ~ShowsComposition));
            case Win32Message.CompositionBegins when isInPlace:
                Place();
                return 0;
            case Win32Message.Composition when isInPlace:
                With(context => OnComposition(context, (uint)l));
                return 0;
            case Win32Message.CompositionEnds when isInPlace:
                _client?.SetPreeditText(null);
                return 0;
            default:
                return null;
        }
    }

    private static string Read(nint context, uint what)
    {
        var bytes = Imm32.ImmGetCompositionString(context, what, null, 0);
        if (bytes <= 0)
        {
            return "";
        }

        var text = new char[bytes / sizeof(char)];
        fixed (char* buffer = text)
        {
            _ = Imm32.ImmGetCompositionString(context, what, buffer, (uint)bytes);
        }

        return new(text);
    }

    private void OnTappedAgain(object? sender, EventArgs e) => BringKeyboard();

    private void BringKeyboard()
    {
        if (!window.IsByFinger)
        {
            return;
        }

        if (!_isKeyboardSought)
        {
            (_keyboard, _isKeyboardSought) = (Win32TouchKeyboard.For(window.Window), true);
        }

        _keyboard?.Show(true);
    }

    private void PutAwayKeyboard()
    {
        if (_client is null)
        {
            _keyboard?.Show(false);
        }
    }

    private void OnComposition(nint context, uint changes)
    {
        if ((changes & Imm32.Finished) != 0 && Read(context, Imm32.Finished) is { Length: > 0 } finished)
        {
            _client?.SetPreeditText(null);
            window.Text(finished, Win32Window.TimeOfMessage);
        }

        if ((changes & Imm32.Composed) != 0)
        {
            var composed = Read(context, Imm32.Composed);
            var caret = Imm32.ImmGetCompositionString(context, Imm32.Caret, null, 0) & 0xFFFF;
            _client?.SetPreeditText(composed, Math.Min(caret, composed.Length));
        }

        Place();
    }

    // Beside the caret and not over it.
    private void Place() => With(context =>
    {
        var pixels = PixelRect.FromRect(_caret, window.RenderScaling);
        var area = new User32.Rect { Left = pixels.X, Top = pixels.Y, Right = pixels.Right, Bottom = pixels.Bottom };
        var form = new Imm32.Form { Kind = Imm32.AtPoint, At = new() { X = pixels.X, Y = pixels.Y }, Area = area };
        _ = Imm32.ImmSetCompositionWindow(context, &form);
        var candidates = new Imm32.CandidateForm { Kind = Imm32.Outside, At = new() { X = pixels.X, Y = pixels.Bottom }, Area = area };
        _ = Imm32.ImmSetCandidateWindow(context, &candidates);
    });

    private void With(Action<nint> act)
    {
        var context = window.Window == 0 ? 0 : Imm32.ImmGetContext(window.Window);
        if (context != 0)
        {
            act(context);
            _ = Imm32.ImmReleaseContext(window.Window, context);
        }
    }
}
