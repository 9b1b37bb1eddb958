using Avalonia.Input;
using Avalonia.Input.Platform;
using ErrorMatching.Hmi.Platform;

namespace ErrorMatching.Hmi.Testing;

/// <summary>A clipboard inside the process.</summary>
internal sealed class MemoryClipboard : IClipboard
{
    private IAsyncDataTransfer? _data;

    public Task ClearAsync() => SetDataAsync(null);

    public Task SetDataAsync(IAsyncDataTransfer? dataTransfer)
    {
        _data = dataTransfer;
        return Task.CompletedTask;
    }

    public Task FlushAsync() => Task.CompletedTask;

    public Task<IAsyncDataTransfer?> TryGetDataAsync() =>
        Task.FromResult<IAsyncDataTransfer?>(_data is null ? null : new StoredTransfer(_data));

    public Task<IAsyncDataTransfer?> TryGetInProcessDataAsync() => Task.FromResult(_data);
}
