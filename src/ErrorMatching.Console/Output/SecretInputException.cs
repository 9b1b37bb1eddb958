namespace ErrorMatching.Console;

/// <summary>A requested password could not be read.</summary>
internal sealed class SecretInputException(string message) : Exception(message);
