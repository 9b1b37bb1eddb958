using System.Runtime.ExceptionServices;

namespace ErrorMatching.Hmi;

/// <summary>Fire-and-forget background work.</summary>
internal static class Watching
{
    /// <summary>Makes an unexpected exception in the task end the program, instead of vanishing with the task.</summary>
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
