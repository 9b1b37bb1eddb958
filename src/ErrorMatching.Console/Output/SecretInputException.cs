namespace ErrorMatching.Console;

/// <summary>A password that was asked for and did not come.</summary>
internal sealed class SecretInputException(string message) : Exception(message);
