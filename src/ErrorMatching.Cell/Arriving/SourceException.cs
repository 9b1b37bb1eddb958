namespace ErrorMatching.Cell;

/// <summary>A gauge's folder that cannot be looked into.</summary>
/// <param name="message">A sentence for a setter: gauge, folder, what was answered, what to do next.</param>
/// <param name="cause">What lies below; null if nothing does.</param>
public sealed class SourceException(string message, Exception? cause = null) : Exception(message, cause);
