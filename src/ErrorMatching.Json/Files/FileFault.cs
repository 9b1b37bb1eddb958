namespace ErrorMatching.Json;

/// <summary>Why a file cannot be opened, in words that do not depend on the system.</summary>
public static class FileFault
{
    /// <summary>The reason, as the end of a sentence without a period.</summary>
    /// <param name="path">The file that was named.</param>
    /// <param name="failure">What came of opening it.</param>
    public static string Of(string path, Exception failure)
    {
        ArgumentNullException.ThrowIfNull(failure);
        return failure switch
        {
            _ when Directory.Exists(path) => "it is a folder",
            FileNotFoundException => "there is no such file",
            DirectoryNotFoundException => "its folder does not exist",
            UnauthorizedAccessException => "access to it is denied",
            _ => failure.Message.TrimEnd('.'),
        };
    }
}
