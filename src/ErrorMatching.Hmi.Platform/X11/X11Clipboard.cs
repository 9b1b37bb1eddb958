using System.Text;
using Avalonia.Input;
using Avalonia.Input.Platform;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The clipboard shared by all programs on the screen (ICCCM 2, selection CLIPBOARD), for text. Copied text remains available
/// until another program copies or the station ends.</summary>
[System.Diagnostics.CodeAnalysis.SuppressMessage("Design", "CA1001", Justification = "It lives as long as the process.")]
internal sealed class X11Clipboard : IClipboard
{
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(5);
    private readonly Lazy<X11ClipboardWindow> _window = new(() => new());
    private readonly SemaphoreSlim _reading = new(1, 1);
    private IAsyncDataTransfer? _own;

    public Task ClearAsync() => SetDataAsync(null);

    public async Task SetDataAsync(IAsyncDataTransfer? dataTransfer)
    {
        // Read now, so that an external request can be answered immediately.
        var text = dataTransfer is null ? null : await dataTransfer.TryGetTextAsync();
        _own = dataTransfer;
        _window.Value.Offer(text is null ? null : Encoding.UTF8.GetBytes(text), () => _own = null);
    }

    public Task FlushAsync() => Task.CompletedTask;

    public Task<IAsyncDataTransfer?> TryGetInProcessDataAsync() => Task.FromResult(_own);

    public async Task<IAsyncDataTransfer?> TryGetDataAsync()
    {
        // The notice that another program has copied may still be on its way.
        if (_own is not null && _window.Value.IsOwner)
        {
            return new StoredTransfer(_own);
        }

        await _reading.WaitAsync();
        try
        {
            if (await _window.Value.ReadAsync(Patience) is not { } bytes)
            {
                return null;
            }

            var transfer = new DataTransfer();
            transfer.Add(DataTransferItem.CreateText(Encoding.UTF8.GetString(bytes)));
            return transfer;
        }
        finally
        {
            _reading.Release();
        }
    }
}
