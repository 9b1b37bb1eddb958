using Avalonia.Input;
using Avalonia.Input.Platform;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The clipboard, for text. What was copied stays there after the station has ended.</summary>
internal sealed class Win32Clipboard : IClipboard
{
    private const uint UnicodeText = 13;

    // Another program may hold it for a moment, such as one that records what is copied.
    private const int Tries = 50;
    private static readonly TimeSpan Pause = TimeSpan.FromMilliseconds(20);

    public Task ClearAsync() => SetDataAsync(null);

    public async Task SetDataAsync(IAsyncDataTransfer? dataTransfer)
    {
        var text = dataTransfer is null ? null : await dataTransfer.TryGetTextAsync();
        await OpenAsync();
        try
        {
            _ = User32.EmptyClipboard();
            if (text is not null)
            {
                Put(text.ReplaceLineEndings("\r\n"));
            }
        }
        finally
        {
            _ = User32.CloseClipboard();
        }
    }

    public Task FlushAsync() => Task.CompletedTask;

    public Task<IAsyncDataTransfer?> TryGetInProcessDataAsync() => Task.FromResult<IAsyncDataTransfer?>(null);

    public async Task<IAsyncDataTransfer?> TryGetDataAsync()
    {
        await OpenAsync();
        try
        {
            if (Get() is not { } text)
            {
                return null;
            }

            var transfer = new DataTransfer();
            transfer.Add(DataTransferItem.CreateText(text));
            return transfer;
        }
        finally
        {
            _ = User32.CloseClipboard();
        }
    }

    // Avalonia's text fields handle this exception: nothing is copied or pasted.
    private static async Task OpenAsync()
    {
        for (var i = 1; User32.OpenClipboard(Win32Dispatcher.OwnerOfMessages) == 0; i++)
        {
            if (i == Tries)
            {
                throw new TimeoutException("Another program holds the clipboard.");
            }

            await Task.Delay(Pause);
        }
    }

    private static unsafe string? Get()
    {
        var memory = User32.GetClipboardData(UnicodeText);
        var at = memory == 0 ? 0 : Kernel32.GlobalLock(memory);
        if (at == 0)
        {
            return null;
        }

        // Other programs write it: it may lack the zero at its end.
        var characters = new ReadOnlySpan<char>((void*)at, (int)Math.Min(Kernel32.GlobalSize(memory) / sizeof(char), int.MaxValue));
        var end = characters.IndexOf('\0');
        var text = (end < 0 ? characters : characters[..end]).ToString();
        _ = Kernel32.GlobalUnlock(memory);
        return text;
    }

    private static unsafe void Put(string text)
    {
        var memory = Kernel32.GlobalAlloc(Kernel32.Movable, ((nuint)text.Length + 1) * sizeof(char));
        var at = memory == 0 ? 0 : Kernel32.GlobalLock(memory);
        if (at == 0)
        {
            return;
        }

        text.CopyTo(new Span<char>((void*)at, text.Length));
        ((char*)at)[text.Length] = '\0';
        _ = Kernel32.GlobalUnlock(memory);

        // From then on it is the system's.
        if (User32.SetClipboardData(UnicodeText, memory) == 0)
        {
            _ = Kernel32.GlobalFree(memory);
        }
    }
}
