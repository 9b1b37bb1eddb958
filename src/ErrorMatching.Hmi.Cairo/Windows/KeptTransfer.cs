using Avalonia.Input;

namespace ErrorMatching.Hmi.Cairo;

/// <summary>What a clipboard gives out and keeps: readers dispose what they get.</summary>
internal sealed class KeptTransfer(IAsyncDataTransfer inner) : IAsyncDataTransfer
{
    /// <inheritdoc/>
    public IReadOnlyList<DataFormat> Formats => inner.Formats;

    /// <inheritdoc/>
    public IReadOnlyList<IAsyncDataTransferItem> Items => inner.Items;

    /// <inheritdoc/>
    public void Dispose()
    {
        // The clipboard goes on owning it.
    }
}
