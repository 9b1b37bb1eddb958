using System.Runtime.ExceptionServices;

namespace ErrorMatching.Hmi;

/// <summary>Work that goes on beside the screen and that nobody waits for.</summary>
internal static class Watching
{
    /// <summary>Lets a defect in it end the program like any other one, and not vanish with the task.</summary>
    public static Task Watched(this Task task)
    {
        var screen = SynchronizationContext.Current;
        _ = task.ContinueWith(
            t => screen?.Post(_ => ExceptionDispatchInfo.Throw(t.Exception!.GetBaseException()), null),
            CancellationToken.None,
            TaskContinuationOptions.OnlyOnFaulted | TaskContinuationOptions.ExecuteSynchronously,
            TaskScheduler.Default);
        return task;
    }
}
