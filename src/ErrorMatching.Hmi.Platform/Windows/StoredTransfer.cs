using Avalonia.Input;

namespace ErrorMatching.Hmi.Platform;

/// <summary>Wraps a transfer that the clipboard returns and keeps: readers dispose of what they get.</summary>
internal sealed class StoredTransfer(IAsyncDataTransfer inner) : IAsyncDataTransfer
{
    public IReadOnlyList<DataFormat> Formats => inner.Formats;

    public IReadOnlyList<IAsyncDataTransferItem> Items => inner.Items;

    public void Dispose()
    {
        // The clipboard still owns it.
    }
}
