using Avalonia.Input;
using Avalonia.Input.Platform;

namespace ErrorMatching.Hmi.Cairo;

/// <summary>A clipboard that lives in the process.</summary>
internal sealed class MemoryClipboard : IClipboard
{
    private IAsyncDataTransfer? _data;

    /// <inheritdoc/>
    public Task ClearAsync() => SetDataAsync(null);

    /// <inheritdoc/>
    public Task SetDataAsync(IAsyncDataTransfer? dataTransfer)
    {
        _data = dataTransfer;
        return Task.CompletedTask;
    }

    /// <inheritdoc/>
    public Task FlushAsync() => Task.CompletedTask;

    /// <inheritdoc/>
    public Task<IAsyncDataTransfer?> TryGetDataAsync() => Task.FromResult<IAsyncDataTransfer?>(_data is null ? null : new KeptTransfer(_data));

    /// <inheritdoc/>
    public Task<IAsyncDataTransfer?> TryGetInProcessDataAsync() => Task.FromResult(_data);
}
